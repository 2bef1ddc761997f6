// Prints nodes, one per line, for debugging and for tests:
//
//   n4 = mult(p.x, 2)
//   n5 = sin(n4)
//
// Constants, inputs and loop variables are printed in place.
#pragma once

#include <span>
#include <string>

#include "graph/graph.hpp"

namespace warpjet {

// Returns the name of a node in the output of `print`.
std::string nameOf(const Graph& graph, NodeId id);

// Prints all nodes that the roots need.
std::string print(const Graph& graph, std::span<const NodeId> roots);

}  // namespace warpjet
