#include "graph/simplify.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "graph/turns.hpp"

namespace warpjet {

namespace {

using Simplified = std::optional<NodeId>;

constexpr Op Neg = ops::find("neg"), Add = ops::find("add"), Sub = ops::find("sub"),
             Mult = ops::find("mult"), Div = ops::find("div"), Pow = ops::find("pow"),
             Min = ops::find("min"), Max = ops::find("max"), Not = ops::find("not"),
             Sqrt = ops::find("sqrt"), IfElse = ops::find("ifElse"),
             IntIfElse = ops::find("intIfElse");

// The largest exponent whose power is written as products (exact for a negative base).
constexpr double maxProductExponent = 16;

bool isNormalFloat32(double x) {
  using Limits = std::numeric_limits<float>;
  return std::abs(x) >= Limits::min() && std::abs(x) <= Limits::max();
}

// A constant comes last in a sum or product, as artists write it.
void putConstantLast(const Graph& graph, Operands<NodeId>& operands) {
  if (graph.isConstant(operands[0])) std::swap(operands[0], operands[1]);
}

// c ? a : 0, plus c ? 0 : b, is c ? a : b.
Simplified mergeChoices(Graph& graph, NodeId x, NodeId y) {
  if (!graph.is(x, IfElse) || !graph.is(y, IfElse)) return {};
  if (graph.operand(x, 0) != graph.operand(y, 0)) return {};
  for (int branch = 1; branch <= 2; ++branch) {
    if (!graph.isConstant(graph.operand(x, branch), 0) &&
        !graph.isConstant(graph.operand(y, branch), 0))
      return {};
  }
  const NodeId yes = graph.apply(Add, {graph.operand(x, 1), graph.operand(y, 1)});
  const NodeId no = graph.apply(Add, {graph.operand(x, 2), graph.operand(y, 2)});
  return graph.apply(IfElse, {graph.operand(x, 0), yes, no});
}

// (x + a) + b, for constants: offsets that turn about a point take it away and add it again.
Simplified mergeConstantTerms(Graph& graph, NodeId sum, double b) {
  if (!graph.is(sum, Add) && !graph.is(sum, Sub)) return {};
  const NodeId term = graph.operand(sum, 1);
  if (!graph.isConstant(term)) return {};
  const double a = graph.is(sum, Add) ? graph.value(term) : -graph.value(term), total = a + b;
  if (total != 0 && !isNormalFloat32(total)) return {};
  return graph.apply(Add, {graph.operand(sum, 0), graph.constant(total)});
}

Simplified simplifyAdd(Graph& graph, Operands<NodeId>& operands) {
  putConstantLast(graph, operands);
  const auto [x, y, unused] = operands;
  if (graph.isConstant(y, 0)) return x;
  if (graph.is(y, Neg)) return graph.apply(Sub, {x, graph.operand(y, 0)});
  if (graph.is(x, Neg)) return graph.apply(Sub, {y, graph.operand(x, 0)});
  if (graph.isConstant(y)) {
    if (const auto merged = mergeConstantTerms(graph, x, graph.value(y))) return merged;
    if (graph.value(y) < 0) return graph.apply(Sub, {x, graph.constant(-graph.value(y))});
  }
  if (x == y) return graph.apply(Mult, {x, graph.constant(2)});
  if (const auto back = turnedBack(graph, x, y, false)) return back;
  return mergeChoices(graph, x, y);
}

Simplified simplifySub(Graph& graph, const Operands<NodeId>& operands) {
  const auto [x, y, unused] = operands;
  if (graph.isConstant(y, 0)) return x;
  if (graph.isConstant(x, 0)) return graph.apply(Neg, {y});
  if (x == y) return graph.constant(0);
  if (graph.is(y, Neg)) return graph.apply(Add, {x, graph.operand(y, 0)});
  if (graph.isConstant(y)) {
    if (const auto merged = mergeConstantTerms(graph, x, -graph.value(y))) return merged;
    if (graph.value(y) < 0) return graph.apply(Add, {x, graph.constant(-graph.value(y))});
  }
  if (!graph.is(x, Neg)) return turnedBack(graph, x, y, true);
  const auto back = turnedBack(graph, graph.operand(x, 0), y, false);
  return back ? Simplified(graph.apply(Neg, {*back})) : std::nullopt;
}

// x * (c ? 1 : 0) is c ? x : 0, which also keeps an infinite x out of the other branch.
Simplified multiplyChoice(Graph& graph, NodeId x, NodeId choice) {
  if (!graph.is(choice, IfElse)) return {};
  const NodeId yes = graph.operand(choice, 1), no = graph.operand(choice, 2);
  const NodeId zero = graph.constant(0);
  if (graph.isConstant(yes, 1) && graph.isConstant(no, 0))
    return graph.apply(IfElse, {graph.operand(choice, 0), x, zero});
  if (graph.isConstant(yes, 0) && graph.isConstant(no, 1))
    return graph.apply(IfElse, {graph.operand(choice, 0), zero, x});
  return {};
}

Simplified simplifyMult(Graph& graph, Operands<NodeId>& operands) {
  putConstantLast(graph, operands);
  const auto [x, y, unused] = operands;
  if (graph.isConstant(y, 0)) return y;
  if (graph.isConstant(y, 1)) return x;
  if (graph.isConstant(y, -1)) return graph.apply(Neg, {x});
  // Before all that could move the infinity of a branch that is not taken next to the zero.
  if (const auto choice = multiplyChoice(graph, x, y)) return choice;
  if (const auto choice = multiplyChoice(graph, y, x)) return choice;
  if (graph.is(x, Neg) && graph.isConstant(y))
    return graph.apply(Mult, {graph.operand(x, 0), graph.constant(-graph.value(y))});
  if (graph.is(x, Neg)) return graph.apply(Neg, {graph.apply(Mult, {graph.operand(x, 0), y})});
  if (graph.is(y, Neg)) return graph.apply(Neg, {graph.apply(Mult, {x, graph.operand(y, 0)})});
  if (graph.isConstant(y) && graph.is(x, Mult) && graph.isConstant(graph.operand(x, 1))) {
    const double product = graph.value(graph.operand(x, 1)) * graph.value(y);
    if (isNormalFloat32(product))
      return graph.apply(Mult, {graph.operand(x, 0), graph.constant(product)});
  }
  for (const auto& [factor, ratio] : {std::pair{x, y}, std::pair{y, x}}) {
    if (graph.is(ratio, Div) && graph.isConstant(graph.operand(ratio, 0), 1))
      return graph.apply(Div, {factor, graph.operand(ratio, 1)});
  }
  return {};
}

Simplified simplifyDiv(Graph& graph, const Operands<NodeId>& operands) {
  const auto [x, y, unused] = operands;
  if (graph.isConstant(y, 1)) return x;
  if (graph.isConstant(y, -1)) return graph.apply(Neg, {x});
  if (graph.isConstant(y, 0)) return {};
  if (graph.isConstant(x, 0)) return x;
  if (graph.is(x, Neg)) return graph.apply(Neg, {graph.apply(Div, {graph.operand(x, 0), y})});
  if (graph.is(y, Neg)) return graph.apply(Neg, {graph.apply(Div, {x, graph.operand(y, 0)})});
  if (graph.is(y, Sqrt) && graph.operand(y, 0) == x) return y;
  return {};
}

// Powers by repeated squaring; GLSL's pow is undefined for a negative base.
Simplified simplifyPow(Graph& graph, const Operands<NodeId>& operands) {
  const auto [base, power, unused] = operands;
  if (!graph.isConstant(power)) return {};
  const double exponent = graph.value(power);
  if (exponent != std::floor(exponent) || std::abs(exponent) > maxProductExponent) return {};

  NodeId result = graph.constant(1), square = base;
  for (int n = std::abs(static_cast<int>(exponent)); n > 0; n /= 2) {
    if (n % 2 == 1) result = graph.apply(Mult, {result, square});
    if (n > 1) square = graph.apply(Mult, {square, square});
  }
  return exponent < 0 ? graph.apply(Div, {graph.constant(1), result}) : result;
}

Simplified simplifyIfElse(Graph& graph, Op op, const Operands<NodeId>& operands) {
  const auto [condition, yes, no] = operands;
  if (yes == no) return yes;
  if (const auto known = graph.known(condition)) return *known != 0 ? yes : no;
  if (graph.is(condition, Not)) return graph.apply(op, {graph.operand(condition, 0), no, yes});
  return {};
}

// Languages leave clamp undefined where its bounds cross, which only constants cannot do unseen.
Simplified simplifyClamp(Graph& graph, const Operands<NodeId>& operands) {
  const auto [x, low, high] = operands;
  if (!graph.isConstant(low) || !graph.isConstant(high))
    return graph.apply(Min, {graph.apply(Max, {x, low}), high});
  return graph.value(low) > graph.value(high) ? Simplified(high) : std::nullopt;
}

Simplified simplifyMix(Graph& graph, const Operands<NodeId>& operands) {
  const auto [x, y, t] = operands;
  if (graph.isConstant(t, 0)) return x;
  if (graph.isConstant(t, 1)) return y;
  if (graph.isConstant(x, 0)) return graph.apply(Mult, {y, t});
  if (graph.isConstant(y, 0))
    return graph.apply(Mult, {x, graph.apply(Sub, {graph.constant(1), t})});
  return {};
}

}  // namespace

Simplified simplify(Graph& graph, Op op, Operands<NodeId>& operands) {
  const NodeId x = operands[0];
  switch (op) {
    case Add:
      return simplifyAdd(graph, operands);
    case Sub:
      return simplifySub(graph, operands);
    case Mult:
      return simplifyMult(graph, operands);
    case Div:
      return simplifyDiv(graph, operands);
    case Pow:
      return simplifyPow(graph, operands);
    case IfElse:
    case IntIfElse:
      return simplifyIfElse(graph, op, operands);
    case ops::find("clamp"):
      return simplifyClamp(graph, operands);
    case ops::find("mix"):
      return simplifyMix(graph, operands);
    case Neg:
      return graph.is(x, Neg) ? Simplified(graph.operand(x, 0)) : std::nullopt;
    case Not:
      return graph.is(x, Not) ? Simplified(graph.operand(x, 0)) : std::nullopt;
    default:
      return {};
  }
}

}  // namespace warpjet
