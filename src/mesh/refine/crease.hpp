// Where a warp bends the surface sharply: its normals jump there, however short an edge is.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/deviation.hpp"

namespace warpjet {

// Between a point of a triangle, or of an edge, and that of its corners whose normal is turned most
// from its own.
struct Turn {
  std::array<std::uint32_t, 3> corners;
  Weights where;
};

// Which of them hold a jump of about that angle or more. It is looked for by halving the way, so
// that turns that are only steep are none.
std::vector<bool> findJumps(const Mesh& mesh, std::span<const Turn> turns, float angle,
                            const WarpFunction& warp);

}  // namespace warpjet
