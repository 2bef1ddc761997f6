// What all readers of files share: the bytes, the files beside them, and how much may be read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace warpjet {

using Bytes = std::span<const std::uint8_t>;

// The files that a .gltf names, by their URIs as it writes them ("my%20buffer.bin").
using Files = std::map<std::string, std::vector<std::uint8_t>>;

// All the arrays of a mesh together may take so much: 10 million triangles without indices, with
// positions, normals and uvs, fit. A file that says more is refused before its arrays are
// allocated, as are 2^20 parts (primitives times the nodes that show them), 2^22 elements without
// bytes of their own, and descriptions of 2^20 JSON objects, 2^23 values or 64 levels. A program
// may define a limit of its own in place of that in limits.cpp, as tests/fuzz, which must reach it,
// does.
extern const std::size_t mostMeshBytes;

}  // namespace warpjet
