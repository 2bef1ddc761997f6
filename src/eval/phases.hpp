// Finds the arguments of waves and noises, the normal, and the arguments of functions that change
// within a short part of their argument's range. From these, a host can determine how far apart
// samples of a surface may be without missing a crest.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eval/front.hpp"
#include "module/module.hpp"

namespace warpjet {

// A point that a wave or a noise is evaluated at, or the direction of the normal.
struct Phase {
  std::uint32_t size;  // its dimensions
  // Between two samples, the point should move by no more than this: half of a wave, a quarter of
  // a cell of noise, or a radian.
  double step;
};

struct Phases {
  std::vector<Phase> phases;
  std::vector<Front> fronts;
};

// Appends a result to the module: the coordinates of all phases, then one number for each front,
// that `results` depend on and that vary continuously with any of the inputs `varying` (by number).
// Coordinates lack what is the same at all vertices, since samples are compared with each other.
// Small loops are unrolled to find their phases. Fronts in loops are skipped, and so is all in
// larger loops and in functions of the host. Returns phases and fronts in order.
Phases addPhases(Module& module, std::span<const std::uint32_t> results,
                 std::span<const std::uint32_t> varying);

}  // namespace warpjet
