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
  int node;
  glm::dmat4 toWorld;
};

// Primitives times the nodes and instances that show them: far more than any scene draws, far less
// than a file can claim.
inline constexpr std::size_t mostDraws = std::size_t{1} << 20;

[[noreturn]] void refuseDraws();

// The meshes of the default scene, or of the first one, or, without scenes, of all nodes below
// those that are nobody's child. A mesh stands there as often as nodes show it, or their instances
// (EXT_mesh_gpu_instancing); hidden nodes (KHR_node_visibility) show nothing. Throws a
// FileProblem if the nodes are no trees: no node may be reached twice.
std::vector<Placed> placedMeshes(Gltf& gltf);

// Where all nodes are, of whatever scene. Throws likewise.
std::vector<glm::dmat4> placesOfNodes(const Gltf& gltf);

}  // namespace warpjet
