// Puts the last vertices of a mesh where a transform or a skin says.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>

#include "mesh/gltf/skin.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Those from `firstVertex` on, and the triangles from `firstIndex` on: positions and tangents by
// the matrix, normals by its inverse transpose, and where it mirrors, triangles turn over and
// tangents change their hand. What is moved is of length 1 again afterwards, or stays zero. Under
// the identity all bits are kept.
void place(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const glm::dmat4& toWorld);

// The same, each vertex by its own bones: `joints` and `weights` are as many numbers a vertex.
void pose(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const Skin& skin,
          const std::vector<float>& joints, const std::vector<float>& weights);

}  // namespace warpjet
