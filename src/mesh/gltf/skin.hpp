// The transforms of vertices by the bones of a glTF's skins, in the pose of its nodes (glTF 2.0,
// section 3.7.3).
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// For each joint, the transform of a vertex from its bind position to the joint's current position.
struct Skin {
  std::vector<glm::dmat4> joints;
  bool isMirrored = false;  // true if most of the joints mirror
};

// Returns all skins of the model, by index. Throws a FileProblem.
std::vector<Skin> skinsOf(const Gltf& gltf);

// Returns the transform of a vertex: the transforms of its joints, blended by their weights, which
// are scaled to add up to 1. Throws a FileProblem if a joint doesn't exist.
glm::dmat4 blendOf(const Skin& skin, std::span<const float> joints, std::span<const float> weights);

}  // namespace warpjet
