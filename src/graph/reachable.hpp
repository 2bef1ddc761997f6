// Which nodes a result needs.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// The nodes that `roots` need, in ascending order, hence operands before users. The search does not
// enter a node for which `known(id)` holds.
template <class Known>
std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots, Known known) {
  std::vector<NodeId> found;
  std::vector<NodeId> pending(roots.begin(), roots.end());
  std::vector<bool> seen(graph.size());
  while (!pending.empty()) {
    const NodeId id = pending.back();
    pending.pop_back();
    if (seen[index(id)] || known(id)) continue;
    seen[index(id)] = true;
    found.push_back(id);
    for (int i = 0; i < graph.arity(id); ++i) pending.push_back(graph.operand(id, i));
  }
  std::sort(found.begin(), found.end());
  return found;
}

inline std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots) {
  return reachable(graph, roots, [](NodeId) { return false; });
}

}  // namespace warpjet
