// The phases and fronts of a warp (see eval/phases.hpp) at samples of a mesh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <vector>

#include "eval/front.hpp"

namespace warpjet {

struct PhaseSamples {
  std::vector<std::uint32_t> sizes;  // by phase
  std::vector<float> steps;          // by phase
  std::vector<Front> fronts;
  // For each sample the numbers of all phases, then one number for each front.
  std::vector<float> values = {};
  std::vector<float> settled = {};  // see `settleFronts`
  // True after the first cuts: then the mesh is not cut at creases again, even if the object moves
  // in the space of the warp.
  bool areCreasesCut = false;

  std::uint32_t firstFront() const { return std::accumulate(sizes.begin(), sizes.end(), 0u); }
  std::uint32_t stride() const { return firstFront() + static_cast<std::uint32_t>(fronts.size()); }

  bool hasCreasesToCut() const {
    return !areCreasesCut && std::any_of(fronts.begin(), fronts.end(),
                                         [](const Front& front) { return front.isStill(); });
  }

  // Remembers that the mesh needs no cuts at fronts with these numbers, since measuring fronts
  // takes longer than all else if many are near the mesh.
  void settleFronts() {
    settled = values;
    areCreasesCut = true;
  }
  bool areFrontsSettled() const {
    if (settled.size() != values.size()) return false;
    const std::size_t first = firstFront(), size = stride();
    const std::size_t bytes = (size - first) * sizeof(float);
    for (std::size_t start = first; start < values.size(); start += size) {
      // Compares bits, since NaN equals nothing.
      if (std::memcmp(values.data() + start, settled.data() + start, bytes) != 0) return false;
    }
    return true;
  }
};

}  // namespace warpjet
