// The rows of the table in interval arithmetic.
#include "ops/ops.hpp"

namespace warpjet::ops {

namespace {

// Row's own one is where it is sampled.
using Range = warpjet::Interval;

// A condition among intervals: 1 where it can be true, 0 where it can be false.
Range asRange(const Range& x) { return x; }
Range asRange(Truth x) { return {x.canBeFalse ? 0.0 : 1.0, x.canBeTrue ? 1.0 : 0.0}; }

template <Type type>
auto operandAs(const Range& x) {
  if constexpr (type == Type::Bool) {
    return Truth{x.high != 0, x.low == 0};
  } else {
    return x;
  }
}

template <std::size_t Row>
Range rangeOfRow(const std::array<Range, maxArity>& operands) {
  constexpr auto value =
      std::get<Row>(table).value;  // a copy, so that the texts stay out of the program
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    constexpr auto types = infos[Row].signature.operands;
    return asRange(value(operandAs<types[I]>(operands[I])...));
  }
  (std::make_index_sequence<infos[Row].arity>{});
}

constexpr auto ranges = []<std::size_t... Row>(std::index_sequence<Row...>) {
  return std::array{&rangeOfRow<Row>...};
}
(std::make_index_sequence<count>{});

}  // namespace

Range rangeOf(Op op, const std::array<Range, maxArity>& operands) {
  return ranges[static_cast<std::size_t>(op)](operands);
}

}  // namespace warpjet::ops
