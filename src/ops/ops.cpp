#include "ops/ops.hpp"

namespace warpjet::ops {

namespace {

using Operands = std::array<double, maxArity>;

// The operand as the row wants it: a condition as `bool`.
template <std::size_t Row, std::size_t I>
auto operand(const Operands& operands) {
  constexpr bool isCondition = infos[Row].signature.operands[I] == Type::Bool;
  if constexpr (isCondition) {
    return operands[I] != 0;
  } else {
    return operands[I];
  }
}

template <std::size_t Row>
double evaluateRow(const Operands& operands) {
  constexpr auto value =
      std::get<Row>(table).value;  // a copy, so that the texts stay out of the program
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return static_cast<double>(value(operand<Row, I>(operands)...));
  }
  (std::make_index_sequence<infos[Row].arity>{});
}

constexpr auto evaluators = []<std::size_t... Row>(std::index_sequence<Row...>) {
  return std::array{&evaluateRow<Row>...};
}
(std::make_index_sequence<count>{});

}  // namespace

double evaluate(Op op, const Operands& operands) {
  return evaluators[static_cast<std::size_t>(op)](operands);
}

}  // namespace warpjet::ops
