// Fades noise that is finer than a pixel, so that it doesn't sparkle in a fragment shader.
#pragma once

#include <span>
#include <vector>

#include "functions/library.hpp"

namespace warpjet {

// How much a number changes from a pixel to the next one, across and down the screen. Each language
// has its own source.
inline constexpr const char* acrossName = "warpjetAcross";
inline constexpr const char* downName = "warpjetDown";

// Replaces calls of noise by calls of noise that fades, with the width of a pixel at the point, in
// the same graph. Returns the roots. Only a fragment shader can compute that width, and it counts
// as a constant where these roots are derivatives.
std::vector<NodeId> fadeNoise(Graph& graph, Library& library, std::span<const NodeId> roots);

}  // namespace warpjet
