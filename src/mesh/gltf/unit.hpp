// Normalizes the directions of a mesh for files. A warp returns a zero normal where it collapses
// the surface, and lengths from other sources are arbitrary.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Normalizes the normals. Unit vectors keep their bits. A zero normal is replaced by that of the
// triangles around its vertex, or by (0, 0, 1) if these have none either.
std::vector<float> unitNormals(const Mesh& mesh);

// Normalizes tangents of four numbers, the last of which is 1 or -1. A zero tangent is replaced by
// any direction perpendicular to its normal.
std::vector<float> unitTangents(const std::vector<float>& tangents,
                                const std::vector<float>& normals);

}  // namespace warpjet
