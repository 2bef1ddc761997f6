// Estimates the work of evaluating results, so that a host can decide where to compute them.
#pragma once

#include <cstdint>
#include <span>

#include "module/module.hpp"

namespace warpjet {

struct Cost {
  // The number of operations on single floats. The body of a function counts once per call, that of
  // a loop once per iteration.
  double operations = 0;
  bool hasNoise = false;
  // True if only the GPU can evaluate the results: they call a function of the host or read an
  // image.
  bool needsGpu = false;
};

// Returns the cost of evaluating these results once. A node that several results share is
// counted once.
Cost costOf(const Module& module, std::span<const std::uint32_t> results);

}  // namespace warpjet
