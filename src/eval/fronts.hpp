// Finds functions in a graph that can change within a short part of their argument's range.
#pragma once

#include <optional>

#include "eval/front.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// A front, and the node that is its number.
struct FrontAt {
  NodeId argument;
  Front front;

  bool operator==(const FrontAt&) const = default;
};

// Returns the front that an operation makes of one of its operands; empty for operations that make
// none.
std::optional<FrontAt> frontOf(Graph& graph, NodeId id);

}  // namespace warpjet
