// Transforms the vertices that were last appended to a mesh by a matrix or a skin.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>

#include "mesh/gltf/skin.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Transforms the vertices from `firstVertex` on, and the triangles from `firstIndex` on: positions
// and tangents by the matrix, normals by its inverse transpose; a mirroring matrix reverses
// triangles and flips the handedness of tangents. Directions are normalized afterwards, or stay
// zero. The identity preserves all bits.
void place(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const glm::dmat4& toWorld);

// Transforms each vertex by its own bones; `joints` and `weights` have the same number of entries
// per vertex.
void pose(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const Skin& skin,
          const std::vector<float>& joints, const std::vector<float>& weights);

}  // namespace warpjet
