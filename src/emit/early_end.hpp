// Finds loops that may end early. If the number of steps of a loop in shader source is unknown, the
// loop is recorded with the max number of steps, or without one. One of its states becomes 1 once
// the condition of the source fails; from then on, all other states keep their values.
#pragma once

#include <optional>
#include <span>

#include "graph/graph.hpp"

namespace warpjet {

// Finds the flag for the end of a loop: returns the variable of the state that is more than 0.5
// once no further step changes any state, or nullopt if there is none.
std::optional<NodeId> earlyEnd(const Graph& graph, std::span<const State> states);

}  // namespace warpjet
