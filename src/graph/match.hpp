// Matching: an operation on nodes enters, the identity that simplifies it leaves.
#pragma once

#include <array>
#include <cstdint>

#include "graph/rules.hpp"

namespace warpjet::patterns {

// The nodes that the variables of a pattern stand for, by letter.
class Bindings {
 public:
  void clear() { bound_ = 0; }
  NodeId operator[](std::uint8_t variable) const { return nodes_[variable]; }

  // False if the variable stands for another node.
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

// The first rule that matches, or null.
const Rule* findRule(const Graph& graph, Op op, const Operands<NodeId>& operands,
                     Bindings& bindings);

// The value of what is known: of a literal, of constants, and of what is computed from them.
double valueOf(const Graph& graph, const Item* item, const Bindings& bindings);

// A pattern as nodes; `apply` makes those of operations.
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
