// Finds the arguments of waves and noises, from which a host can determine how far apart samples of
// a surface may be without missing a crest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "module/module.hpp"

namespace warpjet {

// A point that a wave or a noise is evaluated at.
struct Phase {
  std::uint32_t size;  // its dimensions
  // Between two samples, the point should move by no more than this: half of a wave, a quarter of
  // a cell of noise.
  double step;
};

// Appends a result to the module: the coordinates of all phases that `results` depend on and that
// vary continuously with any of the inputs `varying` (by number). Waves in a loop or in a function
// of the host have no phases. Returns the phases in order.
std::vector<Phase> addPhases(Module& module, std::span<const std::uint32_t> results,
                             std::span<const std::uint32_t> varying);

}  // namespace warpjet
