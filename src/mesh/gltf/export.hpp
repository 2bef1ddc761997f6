// A mesh as the bytes of a GLB file, binary glTF 2.0.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// The picture of PNG or JPEG by how its bytes begin, or no text: glTF knows no other.
const char* pictureType(const std::vector<std::uint8_t>& bytes);

// The mesh has at least one triangle, and its arrays fit together. One scene, one node, one
// primitive: arrays as they are, but that normals and tangents have length 1 (see unit.hpp), and
// colours are between 0 and 1. What a file may not have is left out: tangents without normals, a
// texture without uvs, and one of another kind than PNG and JPEG (which js-bindings/wasm/mesh.cpp
// refuses before). Throws std::length_error if the file were larger than the 4 GB that its header
// can say.
std::vector<std::uint8_t> exportGlb(const Mesh& mesh);

}  // namespace warpjet
