// Triangulates polygons.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace warpjet {

// Larger polygons are treated as convex: the time is quadratic in the number of corners.
inline constexpr std::size_t maxCutCorners = 4096;

// Returns triangles with the winding of the polygon, as indices of its corners; there are two fewer
// than corners. Each edge of the polygon is an edge of one triangle, so that no warp opens a crack
// at a corner on a straight side. Convex polygons become fans around their first corner; the others
// are ear-clipped (Meisters, "Polygons have ears", 1975) in the projection along the axis that
// their plane faces most. Self-intersecting polygons give arbitrary triangles.
std::vector<std::array<std::uint32_t, 3>> trianglesOfPolygon(
    const std::vector<glm::dvec3>& corners);

}  // namespace warpjet
