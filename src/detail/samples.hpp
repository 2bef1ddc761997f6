// The warped surface at points of a triangle, which show how it bends there.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>

#include "detail/base_mesh.hpp"

namespace warpjet {

// The number of intervals of a side between its samples: see `BaseMesh::sampleOfSide`.
inline constexpr int sampleIntervals = 4;

// Row by row from corner 0, which is alone in its row, to the side opposite to it, each row from
// the side of corner 1 to that of corner 2.
constexpr int sampleAt(int row, int i) { return row * (row + 1) / 2 + i; }
inline constexpr int samplesPerTriangle = sampleAt(sampleIntervals + 1, 0);
using Samples = std::array<glm::vec3, samplesPerTriangle>;

inline constexpr std::array cornerSamples{0, sampleAt(sampleIntervals, 0),
                                          sampleAt(sampleIntervals, sampleIntervals)};

// A part of a triangle with six samples: its corners, and the middles of its sides.
struct Cell {
  std::array<int, 3> corners, middles;
};
inline constexpr std::array cells = [] {
  std::array<Cell, 6> all{};
  int count = 0;
  for (int row = 0; row <= sampleIntervals - 2; ++row) {
    for (int i = 0; i <= row; ++i)
      all[count++] = {{sampleAt(row, i), sampleAt(row + 2, i), sampleAt(row + 2, i + 2)},
                      {sampleAt(row + 1, i), sampleAt(row + 2, i + 1), sampleAt(row + 1, i + 1)}};
  }
  return all;
}();

// Reads the samples of a triangle. `warped` has three numbers for each sample of the mesh.
Samples samplesOf(const BaseMesh& base, std::size_t triangle, std::span<const float> warped);

}  // namespace warpjet
