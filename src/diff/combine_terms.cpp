#include "diff/combine_terms.hpp"

#include <array>

namespace warpjet {

namespace {

constexpr Op Neg = ops::find("neg"), Add = ops::find("add"), Sub = ops::find("sub"),
             Mult = ops::find("mult"), Div = ops::find("div");

// ±id
struct Term {
  NodeId id;
  bool isNegative = false;
};

Term termOf(const Graph& graph, NodeId id, bool isNegative) {
  if (graph.is(id, Neg)) return {graph.operand(id, 0), !isNegative};
  return {id, isNegative};
}

Expression toExpression(Graph& graph, Term term) {
  const Expression node{&graph, term.id};
  return term.isNegative ? -node : node;
}

// Returns the two terms of a sum, or the only term and zero.
std::array<Term, 2> termsOf(Graph& graph, Term sum) {
  const bool isDifference = graph.is(sum.id, Sub);
  if (!isDifference && !graph.is(sum.id, Add)) return {sum, {graph.constant(0)}};
  return {termOf(graph, graph.operand(sum.id, 0), sum.isNegative),
          termOf(graph, graph.operand(sum.id, 1), sum.isNegative != isDifference)};
}

// Returns noNode if there is no such node.
NodeId findNode(const Graph& graph, Op op, NodeId x, NodeId y) {
  return graph.findNode(op, x, y).value_or(noNode);
}

// A product has two factors, and each factor that is a product has two more.
constexpr int maxFactors = 6;

NodeId factorOf(const Graph& graph, NodeId product, int i) {
  const NodeId factor = graph.operand(product, i % 2);
  if (i < 2) return factor;
  return graph.is(factor, Mult) ? graph.operand(factor, i / 2 - 1) : noNode;
}

// Returns the product of the factors other than factor i, if such a node exists.
NodeId restOf(const Graph& graph, NodeId product, int i) {
  const NodeId other = graph.operand(product, 1 - i % 2);
  if (i < 2) return other;
  return findNode(graph, Mult, graph.operand(graph.operand(product, i % 2), 2 - i / 2), other);
}

// Returns the sum of two terms as a multiple of an existing sum or difference, or noNode.
NodeId multipleOf(Graph& graph, Term x, Term y) {
  if (!graph.is(x.id, Mult) || !graph.is(y.id, Mult)) return noNode;
  for (int i = 0; i < maxFactors; ++i) {
    const NodeId factor = factorOf(graph, x.id, i);
    if (factor == noNode) continue;
    for (int k = 0; k < maxFactors; ++k) {
      const NodeId otherFactor = factorOf(graph, y.id, k);
      if (otherFactor == noNode) continue;
      // A constant factor includes its sign, so it may also be the negative of the other factor.
      const bool isOpposite = factor != otherFactor;
      if (isOpposite &&
          !(graph.isConstant(factor) && graph.isConstant(otherFactor, -graph.value(factor))))
        continue;
      const NodeId a = restOf(graph, x.id, i), b = restOf(graph, y.id, k);
      const bool isDifference = x.isNegative != (y.isNegative != isOpposite);
      NodeId sum = findNode(graph, isDifference ? Sub : Add, a, b);
      const bool isReverse = sum == noNode && isDifference;
      if (isReverse) sum = findNode(graph, Sub, b, a);
      if (sum == noNode) continue;
      const NodeId product = graph.apply(Mult, {sum, factor});
      return toExpression(graph, {product, x.isNegative != isReverse}).id;
    }
  }
  return noNode;
}

}  // namespace

Expression combineTerms(Expression x, Expression y) {
  Graph& graph = *x.graph;
  const Term a = termOf(graph, x.id, false), b = termOf(graph, y.id, false);
  if (graph.is(a.id, Div) && graph.is(b.id, Div) &&
      graph.operand(a.id, 1) == graph.operand(b.id, 1)) {
    const auto numerator = [&](Term term) {
      return toExpression(graph, {graph.operand(term.id, 0), term.isNegative});
    };
    return (numerator(a) + numerator(b)) / Expression{&graph, graph.operand(a.id, 1)};
  }
  const auto first = termsOf(graph, a), second = termsOf(graph, b);
  for (int i = 0; i < 4; ++i) {
    const NodeId product = multipleOf(graph, first[i / 2], second[i % 2]);
    if (product == noNode) continue;
    const Expression rest =
        toExpression(graph, first[1 - i / 2]) + toExpression(graph, second[1 - i % 2]);
    return rest + Expression{&graph, product};
  }
  return x + y;
}

}  // namespace warpjet
