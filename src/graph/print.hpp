// Nodes as text, one a line, for debugging and for tests:
//
//   n4 = mult(p.x, 2)
//   n5 = sin(n4)
//
// Constants, inputs and the variables of loops stand where they are read.
#pragma once

#include <span>
#include <string>

#include "graph/graph.hpp"

namespace warpjet {

// What a node is called in such a text.
std::string nameOf(const Graph& graph, NodeId id);

// All nodes that the roots need.
std::string print(const Graph& graph, std::span<const NodeId> roots);

}  // namespace warpjet
