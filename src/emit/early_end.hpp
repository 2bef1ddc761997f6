// Finds loops that may end early: source whose loop ends at a condition in the shader becomes a
// loop of the max number of steps, in which a state becomes 1 once the condition fails, and all
// other states keep their values from then on.
#pragma once

#include <optional>
#include <span>

#include "graph/graph.hpp"

namespace warpjet {

// Returns the variable of the state that is more than 0.5 once no further step changes any state.
std::optional<NodeId> earlyEnd(const Graph& graph, std::span<const State> states);

}  // namespace warpjet
