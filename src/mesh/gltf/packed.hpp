// Compressed parts of a glTF: views (EXT_meshopt_compression) and primitives
// (KHR_draco_mesh_compression). Their bytes are decoded elsewhere, by libraries of the caller.
#pragma once

#include <vector>

#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/packed_part.hpp"

namespace warpjet {

// Returns the compressed parts of a model whose buffers were found. Throws a FileProblem.
std::vector<PackedPart> findPacked(Gltf& gltf);

// Stores the decoded bytes of a part in the model; `index` is that of the part in the list of
// `findPacked`. Throws a FileProblem if they don't have the declared size.
void unpack(Gltf& gltf, std::size_t index, Pieces pieces);

// Throws a FileProblem if a required part has not been unpacked.
void rejectPacked(const Gltf& gltf);

}  // namespace warpjet
