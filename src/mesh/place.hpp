// Puts the last vertices of a mesh where a transform says.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>

#include "mesh/mesh.hpp"

namespace warpjet {

// Those from `firstVertex` on, and the triangles from `firstIndex` on: positions and tangents by
// the matrix, normals by its inverse transpose, and where it mirrors, triangles turn over and
// tangents change their hand. What is moved is of length 1 again afterwards, or stays zero. Under
// the identity exact numbers keep their bits; others (once integers) become of length 1 too.
void place(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const glm::dmat4& toWorld,
           bool isExact);

}  // namespace warpjet
