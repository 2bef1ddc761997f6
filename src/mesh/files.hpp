// Shared by all readers of files: the bytes of a file, the files that it refers to, and the memory
// limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace warpjet {

using Bytes = std::span<const std::uint8_t>;

// The files that a .gltf refers to, by their URIs as written in it ("my%20buffer.bin").
using Files = std::map<std::string, std::vector<std::uint8_t>>;

// The max size of all arrays of a mesh together: 10 million triangles without indices, with
// positions, normals and uvs, fit. A file that declares more is rejected before its arrays are
// allocated. So is a file with more than 2^20 parts (primitives times the nodes that show them),
// 2^22 elements without bytes of their own, 2^20 JSON objects, 2^23 JSON values or 64 levels of
// JSON. A program may define its own limit in place of the one in limits.cpp; tests/fuzz does,
// since it has to reach the limit.
extern const std::size_t maxMeshBytes;

}  // namespace warpjet
