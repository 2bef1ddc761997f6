// Polygons as triangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace warpjet {

// Beyond it a polygon is taken for a convex one: the time grows with the square of its corners.
inline constexpr std::size_t mostCutCorners = 4096;

// Two triangles less than corners, wound as the polygon, by their places in it. Each of its edges
// is an edge of one triangle, so that no warp opens a crack beside a corner that lies on a straight
// side. Convex polygons become fans around their first corner; the others lose their ears one by
// one (Meisters, "Polygons have ears", 1975), seen along the axis that their plane faces most. One
// that crosses itself becomes any triangles.
std::vector<std::array<std::uint32_t, 3>> trianglesOfPolygon(
    const std::vector<glm::dvec3>& corners);

}  // namespace warpjet
