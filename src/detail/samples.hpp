// The warped surface at points of a triangle, which show how it bends there.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detail/base_mesh.hpp"
#include "detail/four_triangles.hpp"

namespace warpjet {

// The number of intervals of a side between its samples: see `BaseMesh::sampleOfSide`.
inline constexpr int sampleIntervals = 4;

// Returns the index of sample i of a row. The rows go from corner 0, which is alone in row 0, to
// the side opposite to it, and each row from the side between corners 0 and 1 to the side between 0
// and 2.
constexpr int sampleAt(int row, int i) { return row * (row + 1) / 2 + i; }
inline constexpr int samplesPerTriangle = sampleAt(sampleIntervals + 1, 0);
// The samples of four triangles.
using Samples = std::array<Vec3, samplesPerTriangle>;
using SampleIndices = std::array<std::uint32_t, samplesPerTriangle>;

inline constexpr std::array cornerSamples{0, sampleAt(sampleIntervals, 0),
                                          sampleAt(sampleIntervals, sampleIntervals)};

// The samples along each side, from corner i to the next one.
inline constexpr auto sideSamples = [] {
  std::array<std::array<int, sampleIntervals + 1>, 3> all{};
  constexpr int end = sampleIntervals;
  for (int k = 0; k <= end; ++k) {
    all[0][k] = sampleAt(k, 0);
    all[1][k] = sampleAt(end, k);
    all[2][k] = sampleAt(end - k, end - k);
  }
  return all;
}();

// A part of a triangle, by the indices of its six samples: its corners, and the middles of its
// sides.
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

// Returns the indices of the samples of a triangle in the mesh: see `BaseMesh::sampleOfSide`.
SampleIndices sampleIndicesOf(const BaseMesh& base, std::size_t triangle);
std::array<SampleIndices, Lanes::count> sampleIndicesOf(const BaseMesh& base,
                                                        const FourTriangles& triangles);

// Reads the samples of triangles. `warped` has three numbers for each sample of the mesh.
Samples samplesOf(const BaseMesh& base, const FourTriangles& triangles,
                  std::span<const float> warped);

}  // namespace warpjet
