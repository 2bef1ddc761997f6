// Intervals that contain all values of a node.
#include <cmath>
#include <limits>

#include "graph/graph.hpp"

namespace warpjet {

namespace {

constexpr Op Mult = ops::find("mult"), Gt = ops::find("gt"), Sqrt = ops::find("sqrt"),
             IfElse = ops::find("ifElse");

// The smallest float32 above zero.
constexpr double minPositive = std::numeric_limits<float>::denorm_min();

}  // namespace

Interval Graph::range(NodeId id) {
  for (std::size_t i = ranges_.size(); i <= index(id); ++i)
    ranges_.push_back(findRange(NodeId{static_cast<std::uint32_t>(i)}, assumedMagnitude, ranges_));
  return ranges_[index(id)];
}

std::vector<Interval> Graph::rangesOfAll() const {
  std::vector<Interval> ranges;
  ranges.reserve(size());
  for (std::uint32_t i = 0; i < size(); ++i)
    ranges.push_back(findRange(NodeId{i}, std::numeric_limits<float>::max(), ranges));
  return ranges;
}

Interval Graph::findRange(NodeId id, double inputSize, const std::vector<Interval>& ranges) const {
  if (isConstant(id)) return value(id);
  if (!isOperation(id)) return {-inputSize, inputSize};
  const Op op = node(id).op;
  Operands<Interval> x;
  for (int i = 0; i < arity(id); ++i) x[i] = ranges[index(operand(id, i))];
  if (op == Mult && operand(id, 0) == operand(id, 1)) return square(x[0]);

  // In x > 0 ? y : …, where y divides by x or by the root of x, the divisor isn't zero.
  const NodeId condition = operand(id, 0), yes = operand(id, 1);
  if (op == IfElse && is(condition, Gt) && isConstant(operand(condition, 1), 0) &&
      isOperation(yes)) {
    const NodeId positive = operand(condition, 0);
    Operands<Interval> y;
    for (int i = 0; i < arity(yes); ++i) {
      const NodeId part = operand(yes, i);
      const bool isRoot = is(part, Sqrt) && operand(part, 0) == positive;
      y[i] = ranges[index(part)];
      if (part == positive) y[i] = clipTo(y[i], minPositive, Interval::infinity);
      if (isRoot) y[i] = clipTo(y[i], std::sqrt(minPositive), Interval::infinity);
    }
    x[1] = ops::rangeOf(node(yes).op, y);
  }
  return ops::rangeOf(op, x);
}

}  // namespace warpjet
