// Finds functions in a graph whose slope jumps where a number passes a limit, such as abs, and
// those whose slope is infinite there, such as the root.
#pragma once

#include <span>
#include <vector>

#include "eval/fronts.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// Returns the kinks and cusps of these nodes: all that the roots need. Lengths by which vectors are
// normalized have no cusp.
std::vector<FrontAt> kinksOf(Graph& graph, std::span<const NodeId> nodes,
                             std::span<const NodeId> roots);

}  // namespace warpjet
