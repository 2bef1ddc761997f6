// Fades noise that is finer than a pixel, so that it doesn't sparkle in a fragment shader.
#pragma once

#include <span>
#include <vector>

#include "functions/library.hpp"
#include "module/comments.hpp"

namespace warpjet {

// Names of functions of the shader that return the change of a number from a pixel to the next,
// along x and along y of the screen. Each language has its own source.
inline constexpr const char* acrossName = "warpjetAcross";
inline constexpr const char* downName = "warpjetDown";

// Returns the roots with each noise replaced by one that fades, which also takes the width of a
// pixel at its point. Only a fragment shader can compute that width. To be applied after
// differentiation: derivatives treat the width as a constant.
std::vector<NodeId> fadeNoise(Graph& graph, Library& library, std::span<const NodeId> roots,
                              Comments& comments);

}  // namespace warpjet
