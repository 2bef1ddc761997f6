// Files of models: .glb, .gltf (2.0), .obj and .stl bytes enter, one Mesh in the space of the scene
// leaves, or one sentence that says what to change. Nothing of a file is trusted: whatever it says
// is checked before it is believed, and no exception leaves. Pictures are handed on encoded.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/gltf/packed_part.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// `problem` is a sentence that starts with "loadMesh: ", and is there exactly if `mesh` is not.
// `warnings` are sentences about what was left out.
struct Loaded {
  std::optional<Mesh> mesh;
  std::vector<std::string> warnings;
  std::string problem;
};

// A file whose description is read once, for both questions about it. The bytes must outlive it.
class ModelFile {
 public:
  explicit ModelFile(Bytes bytes);
  ~ModelFile();

  // See the functions below. A file is loaded once.
  std::vector<std::string> externalFiles(const Files& files = {});
  Loaded load(const Files& files);

  // The compressed parts of a glTF, in place of which `unpack` may put what they are before it is
  // loaded: see gltf/packed_part.hpp. The
  // files must stay where they are until it is loaded. Throws a FileProblem.
  std::vector<PackedPart> packedParts(const Files& files);
  void unpack(std::size_t part, Pieces pieces);

 private:
  struct Description;

  Mesh read(const Files& files, std::vector<std::string>& warnings);
  Description& description();
  Description& readyDescription(const Files& files);

  Bytes bytes_;
  std::string converted_;                     // what bytes_ show of a file in UTF-16
  std::unique_ptr<Description> description_;  // none yet, or none for OBJ and STL
};

// The format is found from the bytes. All triangles of the default scene are merged, each at the
// place that its nodes give it; attributes that only some have are filled (uvs 0, colors 1, normals
// computed; tangents are left out), and unequal base colours move into `colors`. Positions, normals
// and the rest are finite and the indices are in range: problemOf(mesh) is empty.
Loaded loadMesh(Bytes bytes, const Files& files = {});

// The URIs of the files that loadMesh wants in `files`: buffers, without which a model cannot be
// read, and pictures of base colours and .mtl files, which it warns about. The pictures of an .mtl
// file are among them once it is among `files` itself. Nothing where the bytes cannot be read at
// all.
std::vector<std::string> externalFiles(Bytes bytes, const Files& files = {});

}  // namespace warpjet
