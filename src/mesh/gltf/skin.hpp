// Where the bones of a glTF's skins take the vertices, as its nodes stand (glTF 2.0,
// section 3.7.3).
#pragma once

#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// For each joint, what takes a vertex from where it was bound to where the joint now is.
struct Skin {
  std::vector<glm::dmat4> joints;
  bool isMirrored = false;  // by most of the joints
};

// All skins of the model, by their places. Throws a FileProblem.
std::vector<Skin> skinsOf(const Gltf& gltf);

// Of a vertex: its joints' transforms by their weights, made to add up to 1. Throws a FileProblem
// if there is no such joint.
glm::dmat4 blendOf(const Skin& skin, std::span<const float> joints, std::span<const float> weights);

}  // namespace warpjet
