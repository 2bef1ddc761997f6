// Writes a mesh as the bytes of a GLB file, binary glTF 2.0.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// Returns the MIME type of a PNG or JPEG, by its first bytes; null for other formats, which glTF
// doesn't support.
const char* pictureType(const std::vector<std::uint8_t>& bytes);

// Requires at least one triangle and consistent arrays. Writes one scene, one node and one
// primitive, with the arrays unchanged, except that normals and tangents are normalized (see
// unit.hpp) and colors clamped to 0 to 1. If all uvs are from 0 to 1, the normal texture does not
// repeat: at the border of the image, filtering would blend normals of opposite sides. Omits what
// glTF doesn't allow: tangents without normals, a texture without uvs, and textures other than PNG
// and JPEG (js-bindings/wasm/mesh.cpp rejects those earlier). Throws std::length_error if the file
// exceeds 4 GB, the limit of its header.
std::vector<std::uint8_t> exportGlb(const Mesh& mesh);

}  // namespace warpjet
