// Finds the nodes that results depend on: takes roots, returns every node they are computed from,
// operands first.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// Returns the nodes that `roots` need, in ascending order, hence operands before users. The search
// doesn't enter nodes for which `skip(id)` holds.
template <class Skip>
std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots, Skip skip) {
  constexpr std::uint32_t wordSize = 64;
  std::vector<NodeId> pending(roots.begin(), roots.end());
  // One bit per node, scanned by words, since most of a large graph may be unneeded.
  std::vector<std::uint64_t> needed(graph.size() / wordSize + 1);
  std::size_t count = 0;
  while (!pending.empty()) {
    const NodeId id = pending.back();
    pending.pop_back();
    std::uint64_t& word = needed[index(id) / wordSize];
    const std::uint64_t bit = std::uint64_t{1} << index(id) % wordSize;
    if ((word & bit) != 0 || skip(id)) continue;
    word |= bit;
    ++count;
    for (int i = 0; i < graph.arity(id); ++i) pending.push_back(graph.operand(id, i));
  }
  std::vector<NodeId> found;
  found.reserve(count);
  for (std::uint32_t i = 0; found.size() < count; ++i) {
    for (std::uint64_t word = needed[i]; word != 0; word &= word - 1)
      found.push_back(NodeId{i * wordSize + static_cast<std::uint32_t>(std::countr_zero(word))});
  }
  return found;
}

inline std::vector<NodeId> reachable(const Graph& graph, std::span<const NodeId> roots) {
  return reachable(graph, roots, [](NodeId) { return false; });
}

}  // namespace warpjet
