// Normals of a mesh that has none.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Three numbers a vertex, of length 1. Each triangle adds its normal, weighted by its area and by
// its angle at the corner, to all vertices at that place: vertices at equal positions share their
// normal, so that seams of uvs stay smooth. Of a two-sided surface (sheets.hpp) that holds on each
// side for itself; a vertex that both sides use has the normal of that whose triangle comes first.
// Degenerate triangles add nothing; a vertex without any other triangle gets (0, 0, 0), as warps
// also give it where a normal is lost. The indices must be in range and the positions finite.
std::vector<float> computeNormals(const Mesh& mesh);

// Gives such normals to the vertices that have none, and appends a vertex for each further side
// that uses one of them: a vertex has one normal, and those of two sides are opposite.
void addMissingNormals(Mesh& mesh, const std::vector<bool>& hasNormal);

}  // namespace warpjet
