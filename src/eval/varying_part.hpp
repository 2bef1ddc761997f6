// Removes terms that are equal at all vertices. Differences between vertices stay the same, so
// phases need not be computed again when only such a term, as the time, changes.
#pragma once

#include <vector>

#include "eval/dependence.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// Nodes are added in ascending order, after they were added to the `Dependence`.
class VaryingParts {
 public:
  VaryingParts(Graph& graph, const Dependence& dependence)
      : graph_(graph), dependence_(dependence), parts_(graph.size(), noNode) {}

  void add(NodeId id) { parts_[index(id)] = partOf(id); }

  // Returns a node that differs from the given one by a number that is the same at all vertices.
  // Changes at jumps of step functions, such as floor, are left out.
  NodeId operator[](NodeId id) const { return parts_[index(id)]; }

 private:
  NodeId partOf(NodeId id) {
    if (!dependence_.isVarying(id)) return dependence_.isInLoop(id) ? id : graph_.constant(0);
    const Op op = graph_.isOperation(id) ? graph_.node(id).op : inputOp;
    const auto operand = [&](int i) { return graph_.operand(id, i); };
    const auto part = [&](int i) { return parts_[index(operand(i))]; };
    if (op == ops::find("neg")) return graph_.apply(op, {part(0)});
    if (op == ops::find("add") || op == ops::find("sub"))
      return graph_.apply(op, {part(0), part(1)});
    if (op == ops::find("mult") && isUniform(operand(0)))
      return graph_.apply(op, {operand(0), part(1)});
    if ((op == ops::find("mult") || op == ops::find("div")) && isUniform(operand(1)))
      return graph_.apply(op, {part(0), operand(1)});
    return id;
  }

  bool isUniform(NodeId id) const {
    return !dependence_.isVarying(id) && !dependence_.isInLoop(id);
  }

  Graph& graph_;
  const Dependence& dependence_;
  std::vector<NodeId> parts_;
};

}  // namespace warpjet
