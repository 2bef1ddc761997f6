#include "graph/turns.hpp"

#include <array>
#include <utility>

namespace warpjet {

namespace {

constexpr Op Neg = ops::find("neg"), Add = ops::find("add"), Sub = ops::find("sub"),
             Mult = ops::find("mult"), Sin = ops::find("sin"), Cos = ops::find("cos");

// Of cos u and of sin u in a sum of the two, where there are any.
using Coefficients = std::array<NodeId, 2>;
constexpr Coefficients noCoefficients{noNode, noNode};

class TurnedBack {
 public:
  TurnedBack(Graph& graph, NodeId x, NodeId y, bool isDifference)
      : graph_(graph), x_(x), y_(y), isDifference_(isDifference) {}

  std::optional<NodeId> find() {
    for (int i = 0; i < 4; ++i) {
      NodeId cosine = graph_.operand(x_, i / 2), sine = graph_.operand(y_, i % 2);
      NodeId f = graph_.operand(x_, 1 - i / 2), g = graph_.operand(y_, 1 - i % 2);
      const bool isReverse = graph_.is(cosine, Sin);
      if (isReverse) std::swap(cosine, sine), std::swap(f, g);
      angle_ = graph_.operand(cosine, 0);
      if (!graph_.is(cosine, Cos) || !graph_.is(sine, Sin) || !isSineOrCosine(sine)) continue;
      if (const auto found = withoutCommonFactor(f, g))
        return isReverse && isDifference_ ? graph_.apply(Neg, {*found}) : *found;
    }
    return {};
  }

 private:
  std::optional<NodeId> withoutCommonFactor(NodeId f, NodeId g) {
    if (const auto found = turned(f, g, isDifference_)) return found;
    if (!graph_.is(f, Mult) || !graph_.is(g, Mult)) return {};
    for (int i = 0; i < 4; ++i) {
      const NodeId a = graph_.operand(f, i / 2), b = graph_.operand(g, i % 2);
      // A constant has its minus in it.
      const bool isOpposite = a != b;
      if (isOpposite && !(graph_.isConstant(a) && graph_.isConstant(b, -graph_.value(a)))) continue;
      const auto found = turned(graph_.operand(f, 1 - i / 2), graph_.operand(g, 1 - i % 2),
                                isDifference_ != isOpposite);
      if (found) return graph_.apply(Mult, {*found, a});
    }
    return {};
  }

  // (a cos u + b sin u) cos u ± (c cos u + d sin u) sin u is a, if ±d is a and ±c is -b.
  std::optional<NodeId> turned(NodeId f, NodeId g, bool isDifference) {
    Coefficients first = noCoefficients, second = noCoefficients;
    if (!add(first, f, false) || !add(second, g, isDifference)) return {};
    if (first[1] != noNode) first[1] = graph_.apply(Neg, {first[1]});
    if (first[0] == noNode || first[0] != second[1] || first[1] != second[0]) return {};
    return first[0];
  }

  bool add(Coefficients& sum, NodeId id, bool isNegative) {
    const bool isDifference = graph_.is(id, Sub);
    if (!isDifference && !graph_.is(id, Add)) return addPart(sum, id, isNegative);
    return addPart(sum, graph_.operand(id, 0), isNegative) &&
           addPart(sum, graph_.operand(id, 1), isNegative != isDifference);
  }

  bool addPart(Coefficients& sum, NodeId id, bool isNegative) {
    NodeId factor = graph_.constant(1);
    if (graph_.is(id, Neg)) {
      id = graph_.operand(id, 0);
      isNegative = !isNegative;
    }
    if (graph_.is(id, Mult)) {
      const int i = isSineOrCosine(graph_.operand(id, 0)) ? 0 : 1;
      factor = graph_.operand(id, 1 - i);
      id = graph_.operand(id, i);
    }
    NodeId& place = sum[graph_.is(id, Cos) ? 0 : 1];
    if (!isSineOrCosine(id) || place != noNode) return false;
    place = isNegative ? graph_.apply(Neg, {factor}) : factor;
    return true;
  }

  bool isSineOrCosine(NodeId id) const {
    return (graph_.is(id, Sin) || graph_.is(id, Cos)) && graph_.operand(id, 0) == angle_;
  }

  Graph& graph_;
  NodeId x_, y_;
  bool isDifference_;
  NodeId angle_ = noNode;
};

}  // namespace

// Most sums are none of these: out of the way of those, which a warp has thousands of.
[[gnu::noinline, gnu::cold]] std::optional<NodeId> turnedBack(Graph& graph, NodeId x, NodeId y,
                                                              bool isDifference) {
  if (!graph.is(x, Mult) || !graph.is(y, Mult)) return {};
  return TurnedBack(graph, x, y, isDifference).find();
}

}  // namespace warpjet
