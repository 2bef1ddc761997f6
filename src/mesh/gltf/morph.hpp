// Morph targets of a glTF, applied by the weights that the file gives (glTF 2.0, section 3.7.2.2).
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/scene.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// A target, by its place in the primitive, and its weight, which is not 0.
struct MorphWeight {
  std::size_t target;
  double weight;
};

// Those of the node, or of its mesh if the node has none. Warns if there are targets.
std::vector<MorphWeight> morphWeightsOf(Gltf& gltf, const tinygltf::Primitive& primitive,
                                        const Placed& placed);

// Adds the targets to the vertices from `firstVertex` on, which are those of the primitive.
// Attributes that the mesh lacks, and normals that the primitive does, are passed over. Throws a
// FileProblem.
void morph(const Gltf& gltf, const tinygltf::Primitive& primitive,
           const std::vector<MorphWeight>& weights, std::size_t firstVertex, Mesh& mesh);

}  // namespace warpjet
