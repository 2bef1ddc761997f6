#include "ops/rows.hpp"

namespace warpjet::ops {

namespace {

// Converts an operand to the type that the row takes: a condition to `bool`.
template <Type type>
auto operandAs(double x) {
  if constexpr (type == Type::Bool) {
    return x != 0;
  } else {
    return x;
  }
}

template <std::size_t Row>
double valueOfRow(const Operands<double>& operands) {
  constexpr auto value =
      std::get<Row>(table).value;  // a copy, so that the strings stay out of the program
  constexpr auto types = declarations[Row].signature.operands;
  return withIndices<declarations[Row].arity>(
      [&](auto... i) { return static_cast<double>(value(operandAs<types[i]>(operands[i])...)); });
}

constexpr auto values =
    withIndices<count>([](auto... row) { return std::array{&valueOfRow<row>...}; });

constexpr auto steps = std::apply(
    [](const auto&... row) {
      return std::array{std::tuple_size_v<decltype(row.partials)> == 0 ...};
    },
    table);

}  // namespace

bool isStep(Op op) { return steps[static_cast<std::size_t>(op)]; }

double valueOf(Op op, const Operands<double>& operands) {
  return values[static_cast<std::size_t>(op)](operands);
}

}  // namespace warpjet::ops
