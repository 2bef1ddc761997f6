// The order of the statements: needed nodes enter, the same nodes leave in the order of writing.
#pragma once

#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// Nodes in ascending order enter; they leave in an order in which operands still come before their
// users, and each derivative comes right after the value it belongs to. Few values are then alive
// at a time: on three chains of 24 nested sines this order took 150 ms a frame, all values first
// and all derivatives after took 211 ms (500,000 vertices, SwiftShader).
std::vector<NodeId> schedule(const Graph& graph, const std::vector<NodeId>& nodes);

}  // namespace warpjet
