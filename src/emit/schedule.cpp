#include "emit/schedule.hpp"

#include <algorithm>
#include <utility>

namespace warpjet {

std::vector<NodeId> schedule(const Graph& graph, std::vector<NodeId> nodes) {
  // A node is due with its origin, but not before its operands are: interning can make a derivative
  // need a node that the sketch wrote later.
  std::vector<NodeId> due(graph.size());
  for (const NodeId id : nodes) {
    due[index(id)] = graph.origin(id);
    for (int i = 0; i < graph.arity(id); ++i)
      due[index(id)] = std::max(due[index(id)], due[index(graph.operand(id, i))]);
  }
  std::sort(nodes.begin(), nodes.end(), [&](NodeId a, NodeId b) {
    return std::pair(due[index(a)], a) < std::pair(due[index(b)], b);
  });
  return nodes;
}

}  // namespace warpjet
