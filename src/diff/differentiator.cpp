#include "diff/differentiator.hpp"

#include <optional>

#include "graph/expression.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

// The k-th partial derivative of the operation `v` as the table gives it, a node.
template <std::size_t Row, std::size_t K>
NodeId partial(Graph& graph, const std::array<Expression, ops::maxArity>& x, Expression v) {
  constexpr auto& row = std::get<Row>(ops::table);
  constexpr auto& function = std::get<K>(row.partials);
  return toNode(graph, ops::spread<ops::infos[Row].arity>(function, x.data(), v));
}

using Partial = NodeId (*)(Graph&, const std::array<Expression, ops::maxArity>&, Expression);
using Partials = std::array<Partial, ops::maxArity>;

template <std::size_t Row>
constexpr Partials partialsOfRow() {
  using Functions = decltype(std::get<Row>(ops::table).partials);
  return []<std::size_t... K>(std::index_sequence<K...>) { return Partials{&partial<Row, K>...}; }
  (std::make_index_sequence<std::tuple_size_v<Functions>>{});
}

// Null where an operation is locally constant.
constexpr auto partials = []<std::size_t... Row>(std::index_sequence<Row...>) {
  return std::array{partialsOfRow<Row>()...};
}
(std::make_index_sequence<ops::count>{});

}  // namespace

Differentiator::Tangents& Differentiator::tangentsBy(NodeId input) {
  for (auto& [by, tangents] : tangents_) {
    if (by == input) return tangents;
  }
  return tangents_.emplace_back(input, Tangents{}).second;
}

NodeId Differentiator::chainRule(NodeId id, const Tangents& tangents) {
  const int arity = graph_.arity(id);
  const Partials& rowPartials = partials[static_cast<std::size_t>(graph_.node(id).op)];
  std::array<Expression, ops::maxArity> x{};
  for (int i = 0; i < arity; ++i) x[i] = {&graph_, graph_.operand(id, i)};

  std::optional<Expression> sum;
  for (int i = 0; i < arity; ++i) {
    const Expression tangent{&graph_, tangents[index(x[i].id)]};
    if (rowPartials[i] == nullptr || graph_.isConstant(tangent.id, 0)) continue;
    const Expression partial{&graph_, rowPartials[i](graph_, x, {&graph_, id})};
    const Expression term = partial * tangent;
    sum = sum ? *sum + term : term;
  }
  return sum ? sum->id : graph_.constant(0);
}

NodeId Differentiator::derivative(NodeId root, NodeId input) {
  Tangents& tangents = tangentsBy(input);
  tangents.resize(graph_.size(), unknown);
  const auto isKnown = [&](NodeId id) { return tangents[index(id)] != unknown; };
  const NodeId zero = graph_.constant(0), one = graph_.constant(1);
  const auto dependsOnInput = [&](NodeId id) {
    for (int i = 0; i < graph_.arity(id); ++i) {
      if (tangents[index(graph_.operand(id, i))] != zero) return true;
    }
    return false;
  };

  for (const NodeId id : reachable(graph_, {&root, 1}, isKnown)) {
    NodeId tangent = zero;
    if (id == input) {
      tangent = one;
    } else if (dependsOnInput(id)) {
      const Graph::OriginScope scope(graph_, id);
      tangent = chainRule(id, tangents);
    }
    tangents[index(id)] = tangent;
  }
  return tangents[index(root)];
}

}  // namespace warpjet
