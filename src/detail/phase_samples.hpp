// The phases and fronts of a warp (see eval/phases.hpp) at samples of a mesh.
#pragma once

#include <cstdint>
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
  // True after the first cuts: then the mesh is not cut at kinks again, even if the object moves in
  // the space of the warp.
  bool areKinksCut = false;

  std::uint32_t firstFront() const { return std::accumulate(sizes.begin(), sizes.end(), 0u); }
  std::uint32_t stride() const { return firstFront() + static_cast<std::uint32_t>(fronts.size()); }

  // Remembers that the mesh needs no cuts at fronts with these numbers, since measuring fronts
  // takes longer than all else if many are near the mesh.
  void settleFronts() {
    settled = frontValues();
    areKinksCut = true;
  }
  bool areFrontsSettled() const { return frontValues() == settled; }
  std::vector<float> frontValues() const {
    std::vector<float> found;
    for (std::size_t start = 0; start < values.size(); start += stride())
      found.insert(found.end(), values.begin() + start + firstFront(),
                   values.begin() + start + stride());
    return found;
  }
};

}  // namespace warpjet
