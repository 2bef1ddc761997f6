// Keeps fragments on the border of a mesh inside of the domain of a warp that ends there.
#pragma once

#include <span>
#include <vector>

#include "functions/library.hpp"
#include "module/comments.hpp"

namespace warpjet {

// Returns true if an operation of the graph is undefined for some numbers, such as sqrt.
bool hasBorders(const Graph& graph);

// Returns the roots with each number that is less than a pixel outside of the domain of an
// operation reflected at the end of that domain. On an antialiased canvas the center of a pixel may
// be outside of a triangle that covers a part of the pixel, and inputs are extrapolated to there.
// The roots have been differentiated before: derivatives are those at the reflected numbers.
// Numbers inside of the domain, numbers further outside than a pixel, and all numbers in loops
// remain as they are.
std::vector<NodeId> reflectAtBorders(Graph& graph, Library& library, std::span<const NodeId> roots,
                                     Comments& comments);

}  // namespace warpjet
