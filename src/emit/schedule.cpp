#include "emit/schedule.hpp"

#include <algorithm>

namespace warpjet {

std::vector<NodeId> schedule(const Graph& graph, const std::vector<NodeId>& nodes) {
  // A node is due with its origin, but not before its operands are: interning can make a derivative
  // need a node that the sketch wrote later.
  std::vector<NodeId> due(graph.size());
  std::vector<std::uint32_t> start(graph.size() + 1);
  for (const NodeId id : nodes) {
    NodeId& at = due[index(id)] = graph.origin(id);
    for (int i = 0; i < graph.arity(id); ++i) at = std::max(at, due[index(graph.operand(id, i))]);
    ++start[index(at) + 1];
  }
  // A counting sort by due node; within one, ascending ids keep operands first.
  for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
  std::vector<NodeId> order(nodes.size());
  for (const NodeId id : nodes) order[start[index(due[index(id)])]++] = id;
  return order;
}

}  // namespace warpjet
