// Estimates the work of evaluating results, so that a host can decide where to compute them.
#pragma once

#include <cstdint>
#include <span>

#include "module/module.hpp"

namespace warpjet {

struct Cost {
  // Operations on single floats, with the bodies of functions at each call and of loops at each
  // step.
  double operations = 0;
  bool hasNoise = false;
  // True if only the GPU can evaluate the results: they call a function of the host or read an
  // image.
  bool needsGpu = false;
};

// Returns the cost of evaluating these results once. Nodes that several results need count once.
Cost costOf(const Module& module, std::span<const std::uint32_t> results);

}  // namespace warpjet
