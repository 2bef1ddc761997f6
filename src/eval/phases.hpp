// Finds what makes a surface wavy: the arguments of waves and noises, from which a host can tell
// how far apart samples may be without missing a crest.
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

// Modifies the module: adds a result, the last, with the numbers of all phases that the results
// depend on and that vary continuously with any of the inputs `varying` (by number). There are
// none for what happens in a loop or in a function of the host. Returns the phases in order.
std::vector<Phase> addPhases(Module& module, std::span<const std::uint32_t> results,
                             std::span<const std::uint32_t> varying);

}  // namespace warpjet
