// What one row of the operation table is made of.
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "ops/spelling.hpp"
#include "ops/types.hpp"

namespace warpjet::ops {

struct Extent {
  double low, high;
};

// Where an operation may be sampled.
using Domain = Operands<Extent>;

inline constexpr Extent anywhere{-4, 4};
inline constexpr Extent positive{0.05, 4};
inline constexpr Extent negative{-4, -0.05};
inline constexpr Extent belowRightAngle{-1.4, 1.4};
inline constexpr Extent unitInterval{-0.98, 0.98};
inline constexpr Extent aboveOne{1.02, 4};

inline constexpr Domain everywhere{anywhere, anywhere, anywhere};

// In the place of a formula: every language has the operation, or what lacks it refuses it by name.
struct NoFormula {};

// Functions that an operation's spelling calls and that stand above it, by language.
using Helpers = std::array<std::string_view, languageCount>;

// `value` maps operands to the result. It is generic in the scalar: numbers, intervals, and as many
// lanes as a SIMD register has. Written for `double` alone it will do too: lanes are then computed
// one by one, and an interval is anything, unless the row is `Rising`. `partials` holds one
// function an operand, from the operands and the result to the partial derivative, or from those
// and the derivative of the operand to the product of both; an operation without partials is
// locally constant. `lowered` says the operation by others, for languages that lack it.
template <class Value, class Lowered, class... Partials>
struct Row {
  std::string_view name;
  Spellings spellings;
  Domain domain;
  Value value;
  std::tuple<Partials...> partials;
  Lowered lowered;
  Helpers helpers = {};

  constexpr Row helpedBy(const Helpers& texts) const {
    Row row = *this;
    row.helpers = texts;
    return row;
  }

  template <class Formula>
  constexpr Row<Value, Formula, Partials...> loweredTo(Formula formula) const {
    return {name, spellings, domain, value, partials, formula, helpers};
  }
};

template <class Value, class... Partials>
constexpr auto row(std::string_view name, Spellings spellings, Domain domain, Value value,
                   Partials... partials) {
  return Row<Value, NoFormula, Partials...>{name, spellings, domain, value, {partials...}, {}};
}

}  // namespace warpjet::ops
