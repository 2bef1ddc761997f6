// Computes how normals and texture coordinates vary over a mesh, which is needed for a warp along
// the normal; see src/warp/warp.hpp.
#pragma once

#include "mesh/mesh.hpp"

namespace warpjet {

// Fills `gradients`; those of u and v only if there are uvs. Normals are required; indices must be
// in range and numbers finite.
//
// On each triangle, normals and uvs interpolated between its corners have constant derivatives
// (Theisel, Rössl, Zayer and Seidel, "Normal Based Estimation of the Curvature Tensor for
// Triangular Meshes", 2004, section 3). A vertex gets the mean of the derivatives on its triangles,
// rotated from their planes into its own, as in Rusinkiewicz, "Estimating Curvatures and Their
// Derivatives on Triangle Meshes" (2004), section 3.2; of the derivative of the normal only the
// symmetric part, since it is symmetric on a smooth surface. If the normals are those of a smooth
// surface, the means converge to its derivatives as triangles get smaller, and on spheres and
// cylinders they are equal.
//
// Vertices at one position share values if their normals are equal, too, so that hard edges
// separate them; they share the gradients of u and v only if their uvs are also equal, so that
// seams separate them. Triangles without area or with a lost normal add nothing; a vertex of only
// such triangles gets zeros.
void addSurfaceVariation(Mesh& mesh);

}  // namespace warpjet
