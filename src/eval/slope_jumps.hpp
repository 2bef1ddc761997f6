// Tests whether the slope of results jumps at a kink of one of their operations. It doesn't if only
// the square of the operation is used, as in a smooth step, or if a second kink cancels the first,
// as in a bend whose ends continue straight.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eval/fronts.hpp"
#include "module/module.hpp"

namespace warpjet {

// Removes the kinks at which the slope of `results` doesn't jump when the inputs `varying` move
// across. Evaluates the results at both sides of each kink, with arbitrary inputs. Kinks that these
// don't reach stay, and so do those of results that the CPU can't evaluate, or that take too long.
void removeSmoothKinks(std::vector<FrontAt>& kinks, Module& module,
                       std::span<const std::uint32_t> results,
                       std::span<const std::uint32_t> varying);

}  // namespace warpjet
