// Applies the morph targets of a glTF with the weights in the file (glTF 2.0, section 3.7.2.2).
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/scene.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// A target, by its index in the primitive, and its nonzero weight.
struct MorphWeight {
  std::size_t target;
  double weight;
};

// Returns the nonzero weights of the node, or of its mesh if the node has none. Warns if the
// primitive has targets.
std::vector<MorphWeight> morphWeightsOf(Gltf& gltf, const tinygltf::Primitive& primitive,
                                        const Placed& placed);

// Adds the targets to the vertices of the primitive, which start at `firstVertex`. Ignores
// attributes that the mesh lacks, and normals that the primitive lacks. Throws a FileProblem.
void morph(const Gltf& gltf, const tinygltf::Primitive& primitive,
           const std::vector<MorphWeight>& weights, std::size_t firstVertex, Mesh& mesh);

}  // namespace warpjet
