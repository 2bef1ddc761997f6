// Where the nodes of a glTF's scene put its meshes.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// `skin` is its place, or -1: then the mesh stands where the node is.
struct Placed {
  int mesh;
  int skin;
  glm::dmat4 toWorld;
};

// The meshes of the default scene, or of the first one, or, without scenes, of all nodes below
// those that are nobody's child. A mesh stands there as often as nodes show it. Throws a
// FileProblem if the nodes are no trees: no node may be reached twice.
std::vector<Placed> placedMeshes(const Gltf& gltf);

// Where all nodes are, of whatever scene. Throws likewise.
std::vector<glm::dmat4> placesOfNodes(const Gltf& gltf);

}  // namespace warpjet
