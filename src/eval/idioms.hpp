// Idioms: instructions whose range is known, but which interval arithmetic overestimates, since a
// value occurs twice in them.
#pragma once

#include "eval/words.hpp"
#include "ops/interval.hpp"

namespace warpjet {

struct Idiom {
  enum class Kind : std::uint8_t {
    None,
    // x / sqrt(x * x + ...), or x times the inverse: from -1 to 1, where plain arithmetic gives
    // infinity near zero.
    PartOfUnitVector,
    // x * x * (3 - 2 x), which increases from 0 to 1: flat at its ends, where plain arithmetic is
    // steep.
    Smoothstep,
  };

  Kind kind = Kind::None;
  std::uint32_t operand = 0;  // x
};

// Returns the idiom that this instruction completes. `ranges` has the ranges of all earlier
// instructions.
Idiom idiomOf(const Words& words, std::span<const Interval> ranges, std::uint32_t instruction);

// Returns the range of the idiom, given the range of x and the `plain` range, by interval
// arithmetic.
Interval rangeOf(Idiom::Kind kind, const Interval& x, const Interval& plain);

}  // namespace warpjet
