// Operations by number: the part of the table that most files see. Only rows.hpp includes the
// formulas, so that a change of a formula recompiles few files.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "ops/declarations.hpp"
#include "ops/interval.hpp"
#include "ops/spelling.hpp"

namespace warpjet {

// An index into the table.
enum class Op : std::uint8_t {};

namespace ops {

inline constexpr std::size_t count = declarations.size();

constexpr const Declaration& declaration(Op op) {
  return declarations[static_cast<std::size_t>(op)];
}
constexpr bool has(Op op, Trait trait) { return declaration(op).traits.has(trait); }
// Returns true if the first operand selects the second or the third one.
constexpr bool isChoice(Op op) {
  return declaration(op).arity == 3 && declaration(op).signature.operands[0] == Type::Bool;
}

// Not constexpr, so that reaching it at compile time is an error.
void noSuchOperation();

// Returns the operation with that name. An unknown name doesn't compile.
consteval Op find(std::string_view name) {
  for (std::size_t i = 0; i < count; ++i) {
    if (declarations[i].name == name) return static_cast<Op>(i);
  }
  noSuchOperation();
  return {};
}

// Returns true if these rows have the names of the declarations, in the same order.
template <class Rows>
consteval bool haveDeclaredNames(const Rows& rows) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= rows.size() || rows[i].name != declarations[i].name) return false;
  }
  return rows.size() == count;
}

const Spelling& spelling(Op op, Language language);
// Returns the source of the helper functions that the spelling calls; empty if it calls none.
std::string_view helpers(Op op, Language language);

// Returns true if the operation has no partials, which means that it is piecewise constant.
bool isStep(Op op);

// Returns the value of an operation on numbers; conditions are 1 and 0.
double valueOf(Op op, const Operands<double>& operands);

// Returns the range of the result for operands within their ranges.
Interval rangeOf(Op op, const Operands<Interval>& operands);

}  // namespace ops
}  // namespace warpjet
