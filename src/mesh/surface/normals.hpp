// Normals of a mesh that has none.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Three numbers a vertex, of length 1. Each triangle adds its normal, weighted by its area and by
// its angle at the corner, to all vertices at that place: vertices at equal positions share their
// normal, so that seams of uvs stay smooth. Of a two-sided surface (sheets.hpp) that holds on each
// side for itself. Degenerate triangles add nothing; a vertex without any other triangle, or that
// both sides use, gets (0, 0, 0), as warps also give it where a normal is lost. The indices must be
// in range and the positions finite.
std::vector<float> computeNormals(const Mesh& mesh);

}  // namespace warpjet
