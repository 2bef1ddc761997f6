// Computes the normals of a mesh that has none.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Returns three numbers per vertex, normalized. Each triangle adds its normal, weighted by its area
// and by its angle at the corner, to all vertices at that position: vertices at equal positions
// share their normal, so that uv seams stay smooth. On a two-sided surface (sheets.hpp) that
// applies to each side separately; a vertex used by both sides has the normal of the side whose
// triangle comes first. Degenerate triangles add nothing; a vertex of only such triangles gets (0,
// 0, 0), which is also what warps return for lost normals. The indices must be in range and the
// positions finite.
std::vector<float> computeNormals(const Mesh& mesh);

// Computes normals for the vertices that have none, and appends a vertex for each further side that
// uses one of them: a vertex has one normal, and those of two sides are opposite.
void addMissingNormals(Mesh& mesh, const std::vector<bool>& hasNormal);

}  // namespace warpjet
