// The structure of a row of the operation table.
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

// The domain on which tests sample an operation.
using Domain = Operands<Extent>;

inline constexpr Extent anywhere{-4, 4};
inline constexpr Extent positive{0.05, 4};
inline constexpr Extent negative{-4, -0.05};
inline constexpr Extent belowRightAngle{-1.4, 1.4};
inline constexpr Extent unitInterval{-0.98, 0.98};
inline constexpr Extent aboveOne{1.02, 4};

inline constexpr Domain everywhere{anywhere, anywhere, anywhere};

// For rows without a formula: every language has the operation, or languages without it reject it
// by name.
struct NoFormula {};

// Functions that an operation's spelling calls, to be placed before their use, by language.
using Helpers = std::array<std::string_view, languageCount>;

// `value` maps operands to the result. It is generic in the scalar type: numbers, intervals, and
// SIMD registers of several lanes. A function of `double` works, too: lanes are then computed one
// by one, and the interval is unbounded unless the row is `Increasing`. `partials` has one function
// per operand: it takes the operands and the result and returns the partial derivative, or takes
// the derivative of the operand, too, and returns their product. An operation without partials is
// locally constant. `lowered` expresses the operation by others, for languages that lack it.
template <class Value, class Lowered, class... Partials>
struct Row {
  std::string_view name;
  Spellings spellings;
  Domain domain;
  Value value;
  std::tuple<Partials...> partials;
  Lowered lowered;
  Helpers helpers = {};

  constexpr Row withHelpers(const Helpers& texts) const {
    Row row = *this;
    row.helpers = texts;
    return row;
  }

  template <class Formula>
  constexpr Row<Value, Formula, Partials...> lowersTo(Formula formula) const {
    return {name, spellings, domain, value, partials, formula, helpers};
  }
};

template <class Value, class... Partials>
constexpr auto row(std::string_view name, Spellings spellings, Domain domain, Value value,
                   Partials... partials) {
  return Row<Value, NoFormula, Partials...>{name, spellings, domain, value, {partials...}, {}};
}

}  // namespace warpjet::ops
