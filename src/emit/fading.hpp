// Fades noise that is finer than a pixel, so that it doesn't sparkle in a fragment shader.
#pragma once

#include <span>
#include <vector>

#include "functions/library.hpp"
#include "module/comments.hpp"

namespace warpjet {

// Returns the roots with each noise replaced by one that fades, which also takes the width of a
// pixel at its point. Only a fragment shader can compute that width. The roots have been
// differentiated before: derivatives treat the width as a constant.
std::vector<NodeId> fadeNoise(Graph& graph, Library& library, std::span<const NodeId> roots,
                              Comments& comments);

}  // namespace warpjet
