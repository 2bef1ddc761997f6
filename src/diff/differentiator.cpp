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

void Differentiator::forgetIfTooMuch() {
  if (bytes_ < mostBytes) return;
  tangents_.clear();
  components_.clear();
  bytes_ = 0;
}

NodeId Differentiator::whole(const Tangent& tangent) {
  return graph_.apply(ops::find("mult"), {tangent.factor, tangent.base});
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
  std::optional<NodeId> base;
  for (int i = 0; i < graph_.arity(id); ++i) {
    const NodeId operand = graph_.operand(id, i);
    if (components[operand] == 0) continue;
    // The arguments of a call, each with a tangent.
    if (graph_.isList(operand) || graph_.isResult(id)) return {};
    if (components[operand] != components[id]) return {};
    if (base && tangents[operand].base != *base) return {};
    base = tangents[operand].base;
  }
  return base;
}

void Differentiator::findTangent(NodeId id, Tangents& tangents, const Components& components) {
  auto& [factor, base] = tangents.set(id) = {graph_.constant(1), graph_.constant(1)};
  // Not zero; who reads the call asks for the tangent of each argument.
  if (graph_.isList(id) || graph_.isOurCall(id)) return;
  const auto common = commonBase(id, tangents, components);
  (common ? factor : base) = chainRule(id, [&](NodeId operand) {
    return common ? tangents[operand].factor : whole(tangents[operand]);
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
  forgetIfTooMuch();
  const std::uint32_t variable = graph_.node(input).operands[0];
  Components& components = components_[variable];
  Tangents& tangents = tangents_[input];
  const std::size_t before = components.bytes() + tangents.bytes();
  const NodeId zero = graph_.constant(0), one = graph_.constant(1);
  const auto isKnown = [&](NodeId id) { return tangents[id].factor != unknown; };
  const auto dependsOnInput = [&](NodeId id) {
    for (int i = 0; i < graph_.arity(id); ++i) {
      if (tangents[graph_.operand(id, i)].factor != zero) return true;
    }
    return false;
  };
  const auto componentsOf = [&](NodeId id) {
    const Node& node = graph_.node(id);
    const bool isOfInput = graph_.isInput(id) && node.operands[0] == variable;
    std::uint32_t bits = isOfInput ? 1u << node.operands[1] : 0;
    for (int i = 0; i < graph_.arity(id); ++i) bits |= components[graph_.operand(id, i)];
    return bits;
  };

  for (const NodeId id : reachable(graph_, {&root, 1}, isKnown)) {
    if (const std::uint32_t bits = componentsOf(id)) components.set(id) = bits;
    Tangent& tangent = tangents.set(id) = {zero, one};
    if (id == input) {
      tangent.factor = one;
    } else if (dependsOnInput(id)) {
      findTangent(id, tangents, components);
      if (tangent.base == zero) tangent.factor = zero;
    }
  }
  bytes_ += components.bytes() + tangents.bytes() - before;
  return whole(tangents[root]);
}

}  // namespace warpjet
