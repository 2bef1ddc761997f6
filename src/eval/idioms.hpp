// Instructions of a program that interval arithmetic takes for much wider than they are, since a
// value occurs in them twice, and whose range is known: found by their form.
#pragma once

#include "eval/words.hpp"
#include "ops/interval.hpp"

namespace warpjet {

struct Idiom {
  enum class Kind : std::uint8_t {
    None,
    // x / sqrt(x * x + ...), or x times its inverse: from -1 to 1, where plain arithmetic has
    // infinity near zero.
    PartOfUnitVector,
    // x * x * (3 - 2 x), which rises from 0 to 1: flat at its ends, where plain arithmetic is
    // steep.
    Smoothstep,
  };

  Kind kind = Kind::None;
  std::uint32_t operand = 0;  // x
};

// What this instruction is, where the instructions have these ranges.
Idiom idiomOf(const Words& words, std::span<const Interval> ranges, std::uint32_t instruction);

// The range of the idiom, for these of x and of plain arithmetic.
Interval rangeOf(Idiom::Kind kind, const Interval& x, const Interval& plain);

}  // namespace warpjet
