// Merges the draws of a glTF to one mesh in the space of the scene.
#pragma once

#include "mesh/gltf/gltf.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Throws a FileProblem.
Mesh mergeDraws(Gltf& gltf, const Files& files);

}  // namespace warpjet
