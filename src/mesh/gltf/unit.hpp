// The directions of a mesh as files need them: of length 1, all of them. A warp leaves a zero
// normal where it collapses the surface, and lengths that come from elsewhere are whatever they
// are.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// What has length 1 already stays the same to the bit. A zero normal becomes that of the triangles
// around its vertex, or z where those have none either.
std::vector<float> unitNormals(const Mesh& mesh);

// Four numbers each, the last 1 or -1. A zero tangent becomes any direction that is perpendicular
// to its normal.
std::vector<float> unitTangents(const std::vector<float>& tangents,
                                const std::vector<float>& normals);

}  // namespace warpjet
