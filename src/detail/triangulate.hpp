// Triangulates points in the plane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace warpjet {

using Corners = std::array<std::uint32_t, 3>;

// Returns a Delaunay triangulation, counterclockwise. The first `hullSize` points are the corners
// of a convex polygon, counterclockwise, and the others lie inside it.
std::vector<Corners> triangulate(std::span<const glm::dvec2> points, std::size_t hullSize);

}  // namespace warpjet
