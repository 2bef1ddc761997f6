// Pattern matching: takes an operation on nodes, finds the identity that simplifies it.
#pragma once

#include <array>
#include <cstdint>

#include "graph/rules.hpp"

namespace warpjet::patterns {

// Maps the variables of a pattern, by letter, to the nodes that they are bound to.
class Bindings {
 public:
  void clear() { bound_ = 0; }
  NodeId operator[](std::uint8_t variable) const { return nodes_[variable]; }

  // Returns false if the variable is already bound to another node.
  bool bind(std::uint8_t variable, NodeId node) {
    const std::uint32_t bit = std::uint32_t{1} << variable;
    if ((bound_ & bit) != 0) return nodes_[variable] == node;
    bound_ |= bit;
    nodes_[variable] = node;
    return true;
  }

 private:
  std::uint32_t bound_ = 0;
  std::array<NodeId, 26> nodes_;
};

// Returns the rules that the kinds of the operands admit, as bits; 0 for most operations.
inline std::uint32_t findCandidates(const Graph& graph, Op op, const Operands<NodeId>& operands) {
  const std::uint8_t bucketIndex = rules.bucketOf[index(op)];
  if (bucketIndex == Rules::noBucket) return 0;
  const Bucket& bucket = rules.buckets[bucketIndex];
  std::uint32_t candidates = operands[0] == operands[1] ? ~std::uint32_t{0} : ~bucket.ofEqual;
  for (int i = 0; i < arities[index(op)]; ++i)
    candidates &= bucket.candidates[i][kindOf(graph, operands[i])];
  return candidates;
}

// Returns the first candidate that matches, or null.
const Rule* findRule(const Graph& graph, Op op, const Operands<NodeId>& operands,
                     std::uint32_t candidates, Bindings& bindings);

// Returns the value of a known item: a literal, a constant, or a function of known items.
double valueOf(const Graph& graph, const Item* item, const Bindings& bindings);

// Builds the nodes of a pattern; `apply` makes the node of an operation.
template <class Apply>
NodeId build(Graph& graph, const Item* item, const Bindings& bindings, const Apply& apply) {
  if (item->isVariable()) return bindings[item->number];
  if (item->isKnown) return graph.constant(valueOf(graph, item, bindings));
  Operands<NodeId> operands{};
  const Item* operand = item + 1;
  for (int i = 0; i < arities[index(item->op())]; ++i, operand += operand->size)
    operands[i] = build(graph, operand, bindings, apply);
  return apply(item->op(), operands);
}

}  // namespace warpjet::patterns
