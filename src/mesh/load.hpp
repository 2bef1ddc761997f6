// Files of models: .glb, .gltf (2.0) and .obj bytes enter, one Mesh in the space of the scene
// leaves, or one sentence that says what to change. Nothing of a file is trusted: whatever it says
// is checked before it is believed, and no exception leaves. Pictures are handed on encoded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

// The files that a .gltf names, by their URIs as it writes them ("my%20buffer.bin").
using Files = std::map<std::string, std::vector<std::uint8_t>>;

// `problem` is a sentence that starts with "loadMesh: ", and is there exactly if `mesh` is not.
// `warnings` are sentences about what was left out.
struct Loaded {
  std::optional<Mesh> mesh;
  std::vector<std::string> warnings;
  std::string problem;
};

// All the arrays of a mesh together may take so much: 10 million triangles without indices, with
// positions, normals and uvs, fit. A file that says more is refused before its arrays are
// allocated, as are 2^20 parts (primitives times the nodes that show them), 2^22 elements without
// bytes of their own, and descriptions of 2^20 JSON objects, 2^23 values or 64 levels. A program
// may define a limit of its own in place of that in limits.cpp, as tests/fuzz, which must reach it,
// does.
extern const std::size_t mostMeshBytes;

// The format is found from the bytes. All triangles of the default scene are merged, each at the
// place that its nodes give it; attributes that only some have are filled (uvs 0, colors 1, normals
// computed; tangents are left out), and unequal base colours move into `colors`. Positions, normals
// and the rest are finite and the indices are in range: problemOf(mesh) is empty.
Loaded loadMesh(std::span<const std::uint8_t> bytes, const Files& files = {});

// The URIs of the files that loadMesh wants in `files`: buffers, without which a model cannot be
// read, and pictures of base colours, which it warns about. Nothing where the bytes cannot be read
// at all.
std::vector<std::string> externalFiles(std::span<const std::uint8_t> bytes);

}  // namespace warpjet
