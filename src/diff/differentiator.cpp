#include "diff/differentiator.hpp"

#include <algorithm>
#include <optional>

#include "diff/combine_terms.hpp"
#include "diff/partials.hpp"
#include "graph/expression.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

constexpr Op Mult = ops::find("mult"), Div = ops::find("div"), Atan = ops::find("atan"),
             Atan2 = ops::find("atan2");

// Returns the node whose operands an operation is differentiated with respect to. atan(y / x) has
// the derivative of atan2(y, x), which is finite also where the quotient is infinite.
NodeId operandsOf(const Graph& graph, NodeId id) {
  const bool isAngle = graph.is(id, Atan) && graph.is(graph.operand(id, 0), Div);
  return isAngle ? graph.operand(id, 0) : id;
}

const Partials& partialsOf(const Graph& graph, NodeId id) {
  return partialsOf(operandsOf(graph, id) == id ? graph.node(id).op : Atan2);
}

// Adds products, except those with a zero factor.
class Sum {
 public:
  Sum(Graph& graph, NodeId zero) : graph_(graph), zero_(zero) {}

  template <class Product>
  void add(NodeId tangent, Product product) {
    if (graph_.isConstant(tangent, 0)) return;
    const Expression term = product(Expression{&graph_, tangent});
    sum_ = sum_ ? combineTerms(*sum_, term) : term;
  }

  NodeId total() const { return sum_ ? sum_->id : zero_; }

 private:
  Graph& graph_;
  NodeId zero_;
  std::optional<Expression> sum_;
};

}  // namespace

void Differentiator::clearIfTooLarge() {
  if (bytes_ < maxBytes) return;
  tangents_.clear();
  components_.clear();
  bytes_ = 0;
}

NodeId Differentiator::fullTangent(const Tangent& tangent) {
  return graph_.apply(Mult, {tangent.factor, tangent.base});
}

// Returns the common base of all operands, if each depends on the same components as the node.
// Branching operations always start with their own bases: the base of the branch not taken may be
// infinite, and multiplying it by a factor of 0 would give NaN.
std::optional<NodeId> Differentiator::commonBase(NodeId id, const Direction& direction) const {
  const auto& [input, zero, one, tangents, components] = direction;
  if (graph_.isOperation(id) && ops::has(graph_.node(id).op, ops::Trait::Branches)) return {};
  std::optional<NodeId> base;
  const NodeId from = operandsOf(graph_, id);
  for (int i = 0; i < graph_.arity(from); ++i) {
    const NodeId operand = graph_.operand(from, i);
    if (components[operand] == 0) continue;
    // Lists and results belong to calls of our own functions: they read all arguments, and each
    // argument has its own tangent.
    if (graph_.isList(operand) || graph_.isResult(id)) return {};
    if (components[operand] != components[id]) return {};
    if (base && tangents[operand].base != *base) return {};
    base = tangents[operand].base;
  }
  return base;
}

void Differentiator::findTangent(NodeId id, const Direction& direction) {
  Tangents& tangents = direction.tangents;
  auto& [factor, base] = tangents.set(id) = {direction.one, direction.one};
  // Any nonzero value will do: readers of the call use the tangents of its arguments instead.
  if (graph_.isList(id) || graph_.isLibraryCall(id)) return;
  if (const auto common = commonBase(id, direction)) {
    factor = chainRule(id, direction, &Differentiator::factorOf);
    base = *common;
    if (!canOverflow(id, tangents)) return;
    factor = direction.one;
  }
  base = chainRule(id, direction, &Differentiator::fullTangent);
}

// Returns true if the factor or the base may overflow, though their product doesn't: for 1 / r²
// near r = 0, the base r dr is as small as the factor -2 / r⁴ is large.
bool Differentiator::canOverflow(NodeId id, const Tangents& tangents) {
  if (!graph_.isOperation(id)) return false;
  const NodeId from = operandsOf(graph_, id);
  const Partials& partials = partialsOf(graph_, id);
  for (int i = 0; i < graph_.arity(from); ++i) {
    const bool moves = !graph_.isConstant(tangents[graph_.operand(from, i)].factor, 0);
    if (moves && partials[i].canOverflow)
      return canBeInfinite({&graph_, tangents[id].factor}) ||
             canBeInfinite({&graph_, tangents[id].base});
  }
  return false;
}

NodeId Differentiator::chainRule(NodeId id, const Direction& direction, Part part) {
  Sum sum(graph_, direction.zero);
  const auto tangent = [&](NodeId operand) { return (this->*part)(direction.tangents[operand]); };
  if (graph_.isCall(id) || graph_.isResult(id)) {
    for (const auto& [argument, partial] : slopesOf(graph_, id))
      sum.add(tangent(argument), [&, by = partial](Expression d) {
        return Expression{&graph_, by} * d;
      });
    return sum.total();
  }
  const NodeId from = operandsOf(graph_, id);
  const Partials& partials = partialsOf(graph_, id);
  const int arity = graph_.arity(from);
  Operands<Expression> x{};
  for (int i = 0; i < arity; ++i) x[i] = {&graph_, graph_.operand(from, i)};
  for (int i = 0; i < arity; ++i) {
    if (partials[i].times == nullptr) continue;
    sum.add(tangent(x[i].id), [&](Expression d) {
      return partials[i].times(graph_, x, {&graph_, id}, d);
    });
  }
  return sum.total();
}

std::uint32_t Differentiator::componentsOf(NodeId id, const Direction& direction) const {
  const Node& node = graph_.node(id);
  // The components that a state depends on are unknown until its fold is reached.
  if (graph_.isLocal(id)) return graph_.isStep(id) ? 0 : ~std::uint32_t{0};
  const bool isOfInput =
      graph_.isInput(id) && node.operands[0] == graph_.node(direction.input).operands[0];
  std::uint32_t bits = isOfInput ? 1u << node.operands[1] : 0;
  for (int i = 0; i < graph_.arity(id); ++i) bits |= direction.components[graph_.operand(id, i)];
  return bits;
}

void Differentiator::visit(NodeId id, const Direction& direction) {
  const auto& [input, zero, one, tangents, components] = direction;
  const auto dependsOnInput = [&] {
    for (int i = 0; i < graph_.arity(id); ++i) {
      if (direction.tangents[graph_.operand(id, i)].factor != direction.zero) return true;
    }
    return false;
  };

  if (const std::uint32_t bits = componentsOf(id, direction)) components.set(id) = bits;
  if (graph_.has(localOp) && visitFoldPart(id, direction)) return;
  Tangent& tangent = tangents.set(id) = {zero, one};
  if (id == input) {
    tangent.factor = one;
  } else if (dependsOnInput()) {
    const std::size_t before = graph_.size();
    findTangent(id, direction);
    if (tangent.base == zero) tangent.factor = zero;
    if (log_ && graph_.size() > before)
      log_->push_back({static_cast<NodeId>(before), static_cast<NodeId>(graph_.size()), id});
  }
}

NodeId Differentiator::derivative(NodeId root, NodeId input) {
  clearIfTooLarge();
  Components& components = components_[graph_.node(input).operands[0]];
  Tangents& tangents = tangents_[input];
  const std::size_t before = components.bytes() + tangents.bytes();
  const auto isKnown = [&](NodeId id) { return tangents[id].factor != noNode; };
  const std::vector<NodeId> unknown = reachable(graph_, {&root, 1}, isKnown);
  if (!unknown.empty()) {
    const NodeId zero = graph_.constant(0), one = graph_.constant(1);
    for (const NodeId id : unknown) visit(id, {input, zero, one, tangents, components});
  }
  bytes_ += components.bytes() + tangents.bytes() - before;
  return fullTangent(tangents[root]);
}

}  // namespace warpjet
