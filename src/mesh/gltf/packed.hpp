// Compressed parts of a glTF: views (EXT_meshopt_compression) and primitives
// (KHR_draco_mesh_compression). Their bytes are decoded elsewhere, by libraries of the caller.
#pragma once

#include <vector>

#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/packed_part.hpp"

namespace warpjet {

// Those of a model whose buffers are found. Throws a FileProblem.
std::vector<PackedPart> findPacked(Gltf& gltf);

// Puts the decoded bytes of one of them, by its place in that list, into the model. Throws a
// FileProblem if they are not what the file promises.
void unpack(Gltf& gltf, std::size_t place, Pieces pieces);

// Throws a FileProblem if one of them is not optional and has not been unpacked.
void refusePacked(const Gltf& gltf);

}  // namespace warpjet
