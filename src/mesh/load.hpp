// Loads models: takes the bytes of .glb, .gltf (2.0), .obj and .stl files, returns one Mesh in the
// space of the scene, or a message that says what to change. Files are untrusted: everything they
// declare is checked before it is used, and no exception escapes. Images stay encoded.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/gltf/packed_part.hpp"
#include "mesh/mesh.hpp"

namespace warpjet {

// `problem` is a message that starts with "loadMesh: ", empty exactly when `mesh` is present.
// `warnings` are messages about omitted data.
struct Loaded {
  std::optional<Mesh> mesh;
  std::vector<std::string> warnings;
  std::string problem;
};

// A file whose description is parsed once, for all queries. The bytes must outlive it.
class ModelFile {
 public:
  explicit ModelFile(Bytes bytes);
  ~ModelFile();

  // See the functions of the same names below. `load` may be called only once.
  std::vector<std::string> externalFiles(const Files& files = {});
  Loaded load(const Files& files);

  // Returns the compressed parts of a glTF. `unpack` may replace them by their decoded bytes before
  // the file is loaded: see gltf/packed_part.hpp. The files must not move until it is loaded.
  // Throws a FileProblem.
  std::vector<PackedPart> packedParts(const Files& files);
  void unpack(std::size_t part, Pieces pieces);

 private:
  struct Description;

  Mesh read(const Files& files, std::vector<std::string>& warnings);
  Description& description();
  Description& descriptionWithBuffers(const Files& files);

  Bytes bytes_;
  std::string converted_;  // the UTF-8 text of a file in UTF-16, which bytes_ then refers to
  std::unique_ptr<Description> description_;  // null until it is needed, and for OBJ and STL
};

// Detects the format from the bytes. Merges all triangles of the default scene, transformed by
// their nodes; attributes that only some parts have are filled (uvs 0, colors 1, normals computed;
// tangents are omitted), and different base colors are multiplied into `colors`. Positions, normals
// and the rest are finite and the indices are in range: problemOf(mesh) is empty.
Loaded loadMesh(Bytes bytes, const Files& files = {});

// Returns the URIs of the files that loadMesh expects in `files`: buffers, without which a model
// can't be loaded, and base color images and .mtl files, without which it warns. The images of an
// .mtl file are included once it is in `files` itself. Empty if the bytes can't be read at all.
std::vector<std::string> externalFiles(Bytes bytes, const Files& files = {});

}  // namespace warpjet
