// Detects creases: places where a warp makes the normals jump, however short an edge is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/deviation.hpp"

namespace warpjet {

// A point of a triangle or of an edge. Its turn is the piece from the point to the corner whose
// normal differs most from that of the point.
struct Turn {
  std::array<std::uint32_t, 3> corners;
  Weights weights;
};

// Returns for each piece whether the normal jumps on it by about that angle or more. The jump is
// found by bisection, so that steep but smooth turns don't count.
std::vector<bool> findJumps(const Mesh& mesh, std::span<const Turn> turns, float angle,
                            const WarpFunction& warp);

}  // namespace warpjet
