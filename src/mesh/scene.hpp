// Where the nodes of a glTF's scene put its meshes.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "mesh/gltf.hpp"

namespace warpjet {

struct Placed {
  int mesh;
  glm::dmat4 toWorld;
};

// The meshes of the default scene, or of the first one, or, without scenes, of all nodes below
// those that are nobody's child. A mesh stands there as often as nodes show it. Throws a
// FileProblem if the nodes are no trees: no node may be reached twice.
std::vector<Placed> placedMeshes(const Gltf& gltf);

}  // namespace warpjet
