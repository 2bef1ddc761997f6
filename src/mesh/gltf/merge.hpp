// The draws of a glTF as one mesh in the space of the scene.
#pragma once

#include "mesh/gltf/gltf.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// Throws a FileProblem.
Mesh mergedMesh(Gltf& gltf, const Files& files);

}  // namespace warpjet
