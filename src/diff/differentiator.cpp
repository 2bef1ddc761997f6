#include "diff/differentiator.hpp"

#include <algorithm>
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
  for (Tangents& tangents : tangents_) {
    if (tangents.input == input) return tangents;
  }
  return tangents_.emplace_back(Tangents{input});
}

const Differentiator::Components& Differentiator::componentsOf(std::uint32_t input) {
  std::size_t place = 0;
  while (place < components_.size() && components_[place].input != input) ++place;
  if (place == components_.size()) components_.push_back({input});
  auto& bits = components_[place].bits;
  std::size_t i = bits.size();
  bits.resize(graph_.size());
  for (; i < bits.size(); ++i) {
    const NodeId id{static_cast<std::uint32_t>(i)};
    const Node& node = graph_.node(id);
    if (graph_.isInput(id) && node.operands[0] == input) bits[i] = 1u << node.operands[1];
    for (int k = 0; k < graph_.arity(id); ++k) bits[i] |= bits[index(graph_.operand(id, k))];
  }
  return components_[place];
}

NodeId Differentiator::whole(NodeId id, const Tangents& tangents) {
  return graph_.apply(ops::find("mult"), {tangents.factors[index(id)], tangents.bases[index(id)]});
}

// The base of all operands, if they depend on the same components as the node does. A choice begins
// with bases of its own: the one of the branch that is not taken may be infinite, and a factor 0
// before it would not keep it out.
std::optional<NodeId> Differentiator::commonBase(NodeId id, const Tangents& tangents,
                                                 const Components& components) const {
  constexpr Op choices[] = {ops::find("ifElse"), ops::find("min"), ops::find("max"),
                            ops::find("clamp")};
  if (std::find(std::begin(choices), std::end(choices), graph_.node(id).op) != std::end(choices))
    return {};
  const auto& bits = components.bits;
  std::optional<NodeId> base;
  for (int i = 0; i < graph_.arity(id); ++i) {
    const NodeId operand = graph_.operand(id, i);
    if (bits[index(operand)] == 0) continue;
    // The arguments of a call, each with a tangent.
    if (graph_.isList(operand) || graph_.isResult(id)) return {};
    if (bits[index(operand)] != bits[index(id)]) return {};
    if (base && tangents.bases[index(operand)] != *base) return {};
    base = tangents.bases[index(operand)];
  }
  return base;
}

void Differentiator::findTangent(NodeId id, Tangents& tangents, const Components& components) {
  NodeId& factor = tangents.factors[index(id)] = graph_.constant(1);
  NodeId& base = tangents.bases[index(id)] = graph_.constant(1);
  // Not zero; who reads the call asks for the tangent of each argument.
  if (graph_.isList(id) || graph_.isOurCall(id)) return;
  const auto common = commonBase(id, tangents, components);
  (common ? factor : base) = chainRule(id, [&](NodeId operand) {
    return common ? tangents.factors[index(operand)] : whole(operand, tangents);
  });
  if (common) base = *common;
}

template <class TangentOf>
NodeId Differentiator::chainRule(NodeId id, TangentOf tangent) {
  Sum sum(graph_);
  const auto add = [&](NodeId operand, auto partial) { sum.add(tangent(operand), partial); };
  if (graph_.isCall(id) || graph_.isResult(id)) {
    for (const auto& [argument, partial] : slopesOf(graph_, id))
      add(argument, [&by = partial] { return by; });
    return sum.total();
  }
  const int arity = graph_.arity(id);
  const Partials& partials = partialsOf(graph_.node(id).op);
  Arguments x{};
  for (int i = 0; i < arity; ++i) x[i] = {&graph_, graph_.operand(id, i)};
  for (int i = 0; i < arity; ++i) {
    if (partials[i] != nullptr) add(x[i].id, [&] { return partials[i](graph_, x, {&graph_, id}); });
  }
  return sum.total();
}

NodeId Differentiator::derivative(NodeId root, NodeId input) {
  const Components& components = componentsOf(graph_.node(input).operands[0]);
  Tangents& tangents = tangentsBy(input);
  tangents.factors.resize(graph_.size(), unknown);
  tangents.bases.resize(graph_.size(), unknown);
  const NodeId zero = graph_.constant(0), one = graph_.constant(1);
  const auto isKnown = [&](NodeId id) { return tangents.factors[index(id)] != unknown; };
  const auto dependsOnInput = [&](NodeId id) {
    for (int i = 0; i < graph_.arity(id); ++i) {
      if (tangents.factors[index(graph_.operand(id, i))] != zero) return true;
    }
    return false;
  };

  for (const NodeId id : reachable(graph_, {&root, 1}, isKnown)) {
    NodeId& factor = tangents.factors[index(id)] = zero;
    NodeId& base = tangents.bases[index(id)] = one;
    if (id == input) {
      factor = one;
    } else if (dependsOnInput(id)) {
      findTangent(id, tangents, components);
      if (base == zero) factor = zero;
    }
  }
  return whole(root, tangents);
}

}  // namespace warpjet
