// Finds where the nodes of a glTF's scene place its meshes.
#pragma once

#include <glm/mat4x4.hpp>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// `skin` is the index of the skin, or -1 if the node's transform places the mesh.
struct Placed {
  int mesh;
  int skin;
  int node;
  glm::dmat4 toWorld;
};

// The max number of primitives times the nodes and instances that show them: far more than any
// scene draws, far less than a file can declare.
inline constexpr std::size_t maxDraws = std::size_t{1} << 20;

[[noreturn]] void failTooManyDraws();

// Returns the meshes of the default scene; if there is no default, of the first scene; if there are
// no scenes, of all nodes without parents. A mesh occurs as often as nodes or their instances
// (EXT_mesh_gpu_instancing) show it; hidden nodes (KHR_node_visibility) show nothing. Throws a
// FileProblem if the nodes are not trees: no node may be reached twice.
std::vector<Placed> placeMeshes(Gltf& gltf);

// Returns the transforms of all nodes, in any scene. Throws a FileProblem if the nodes are not
// trees.
std::vector<glm::dmat4> placesOfNodes(const Gltf& gltf);

}  // namespace warpjet
