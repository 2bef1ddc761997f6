// Evaluates the rows of the table in interval arithmetic.
#include "ops/rows.hpp"

namespace warpjet::ops {

namespace {

// Returns a condition as an interval: its upper bound is 1 if it can be true, its lower bound 0 if
// it can be false.
Interval asInterval(const Interval& x) { return x; }
Interval asInterval(Truth x) { return {x.canBeFalse ? 0.0 : 1.0, x.canBeTrue ? 1.0 : 0.0}; }

template <Type type>
auto operandAs(const Interval& x) {
  if constexpr (type == Type::Bool) {
    return Truth{x.high != 0, x.low == 0};
  } else {
    return x;
  }
}

template <std::size_t Row>
Interval rangeOfRow(const Operands<Interval>& operands) {
  // Copies the lambda: a reference to the row would link the row's strings into the program.
  constexpr auto value = std::get<Row>(table).value;
  constexpr auto types = declarations[Row].signature.operands;
  return withIndices<declarations[Row].arity>([&](auto... i) {
    using Value = decltype(value);
    if constexpr (std::is_invocable_v<Value, decltype(operandAs<types[i]>(operands[i]))...>) {
      return asInterval(value(operandAs<types[i]>(operands[i])...));
    } else if constexpr (declarations[Row].traits.has(Trait::Increasing)) {
      return increasing(value, operands[0]);
    } else if constexpr (declarations[Row].signature.result == Type::Int) {
      return anyInt();
    } else {
      return declarations[Row].signature.result == Type::Bool ? Interval(0, 1)
                                                              : Interval::anything(true);
    }
  });
}

constexpr auto ranges =
    withIndices<count>([](auto... row) { return std::array{&rangeOfRow<row>...}; });

}  // namespace

Interval rangeOf(Op op, const Operands<Interval>& operands) {
  return ranges[static_cast<std::size_t>(op)](operands);
}

}  // namespace warpjet::ops
