// Operations by number: what most files see of the table. Formulas are seen by rows.hpp alone, so
// that a change of one compiles few files again.
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
// Whether it chooses the second or the third operand by the first.
constexpr bool isChoice(Op op) {
  return declaration(op).arity == 3 && declaration(op).signature.operands[0] == Type::Bool;
}

// Not constexpr, so that reaching it while compiling is an error.
void noSuchOperation();

// The operation of that name. A name that the table lacks does not compile.
consteval Op find(std::string_view name) {
  for (std::size_t i = 0; i < count; ++i) {
    if (declarations[i].name == name) return static_cast<Op>(i);
  }
  noSuchOperation();
  return {};
}

// Whether these rows have the names of the declarations, in their order.
template <class Rows>
consteval bool haveDeclaredNames(const Rows& rows) {
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= rows.size() || rows[i].name != declarations[i].name) return false;
  }
  return rows.size() == count;
}

const Spelling& spelling(Op op, Language language);
// The functions that the spelling calls; empty if it calls none.
std::string_view helpers(Op op, Language language);

// Whether it has no partials, so that it changes only in jumps.
bool isStep(Op op);

// The value of an operation on numbers; conditions are 1 and 0.
double valueOf(Op op, const Operands<double>& operands);

// What it can be where the operands are within theirs.
Interval rangeOf(Op op, const Operands<Interval>& operands);

}  // namespace ops
}  // namespace warpjet
