// Which nodes a result needs: roots enter, all that they are computed from leaves, operands first.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// The nodes that `roots` need, in ascending order, hence operands before users. The search does not
// enter a node for which `skip(id)` holds.
template <class Skip>
std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots, Skip skip) {
  std::vector<NodeId> pending(roots.begin(), roots.end());
  std::vector<bool> needed(graph.size());
  std::uint32_t begin = static_cast<std::uint32_t>(graph.size()), end = 0;
  while (!pending.empty()) {
    const NodeId id = pending.back();
    pending.pop_back();
    if (needed[index(id)] || skip(id)) continue;
    needed[index(id)] = true;
    begin = std::min(begin, index(id));
    end = std::max(end, index(id) + 1);
    for (int i = 0; i < graph.arity(id); ++i) pending.push_back(graph.operand(id, i));
  }
  std::vector<NodeId> found;
  for (std::uint32_t i = begin; i < end; ++i) {
    if (needed[i]) found.push_back(NodeId{i});
  }
  return found;
}

inline std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots) {
  return reachable(graph, roots, [](NodeId) { return false; });
}

}  // namespace warpjet
