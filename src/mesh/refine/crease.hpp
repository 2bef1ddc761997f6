// Detects creases: places where a warp makes the normals jump, however short an edge is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/deviation.hpp"

namespace warpjet {

// The line from a point of a triangle or edge, given by `weights`, to the corner whose warped
// normal differs most from the warped normal of the point.
struct Turn {
  std::array<std::uint32_t, 3> corners;
  Weights weights;
};

// Returns for each line whether the normal jumps on it by about `angle` or more. The jump is found
// by bisection, so that normals that turn steeply but smoothly don't count.
std::vector<bool> findJumps(const Mesh& mesh, std::span<const Turn> turns, float angle,
                            const WarpFunction& warp);

}  // namespace warpjet
