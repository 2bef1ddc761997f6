// Detects creases: places where a warp makes the normals jump, however short an edge is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/deviation.hpp"

namespace warpjet {

// A piece between a point of a triangle or of an edge and the corner whose normal differs most from
// that of the point.
struct Turn {
  std::array<std::uint32_t, 3> corners;
  Weights where;
};

// Finds those with a jump of about that angle or more, by bisection, so that steep but smooth turns
// don't count.
std::vector<bool> findJumps(const Mesh& mesh, std::span<const Turn> turns, float angle,
                            const WarpFunction& warp);

}  // namespace warpjet
