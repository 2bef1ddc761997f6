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

  std::uint32_t firstFront() const { return std::accumulate(sizes.begin(), sizes.end(), 0u); }
  std::uint32_t stride() const { return firstFront() + static_cast<std::uint32_t>(fronts.size()); }
};

}  // namespace warpjet
