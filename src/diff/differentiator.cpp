#include "diff/differentiator.hpp"

#include <optional>

#include "diff/partials.hpp"
#include "graph/expression.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

// The sum of the products, without those whose factor is zero.
class Sum {
 public:
  explicit Sum(Graph& graph) : graph_(graph) {}

  template <class Partial>
  void add(NodeId tangent, Partial partial) {
    if (graph_.isConstant(tangent, 0)) return;
    const Expression term = Expression{&graph_, partial()} * Expression{&graph_, tangent};
    sum_ = sum_ ? *sum_ + term : term;
  }

  NodeId total() const { return sum_ ? sum_->id : graph_.constant(0); }

 private:
  Graph& graph_;
  std::optional<Expression> sum_;
};

}  // namespace

Differentiator::Tangents& Differentiator::tangentsBy(NodeId input) {
  for (auto& [by, tangents] : tangents_) {
    if (by == input) return tangents;
  }
  return tangents_.emplace_back(input, Tangents{}).second;
}

NodeId Differentiator::chainRuleOfCall(NodeId call, const Tangents& tangents) {
  const std::vector<NodeId> by = graph_.arguments(call), given = graph_.partials(call);
  Sum sum(graph_);
  for (std::size_t i = 0; i < by.size(); ++i)
    sum.add(tangents[index(by[i])], [&] { return given[i]; });
  return sum.total();
}

NodeId Differentiator::tangentOf(NodeId id, const Tangents& tangents) {
  if (graph_.isList(id)) return id;  // not zero; the call asks for that of each argument
  return graph_.isCall(id) ? chainRuleOfCall(id, tangents) : chainRule(id, tangents);
}

NodeId Differentiator::chainRule(NodeId id, const Tangents& tangents) {
  const int arity = graph_.arity(id);
  const Partials& rowPartials = partialsOf(graph_.node(id).op);
  Arguments x{};
  for (int i = 0; i < arity; ++i) x[i] = {&graph_, graph_.operand(id, i)};

  Sum sum(graph_);
  for (int i = 0; i < arity; ++i) {
    if (rowPartials[i] == nullptr) continue;
    sum.add(tangents[index(x[i].id)], [&] { return rowPartials[i](graph_, x, {&graph_, id}); });
  }
  return sum.total();
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
      tangent = tangentOf(id, tangents);
    }
    tangents[index(id)] = tangent;
  }
  return tangents[index(root)];
}

}  // namespace warpjet
