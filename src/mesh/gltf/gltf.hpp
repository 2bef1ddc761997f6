// A glTF file, taken apart: what tinygltf makes of its description, and the bytes of its buffers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/files.hpp"
#include "mesh/gltf/container.hpp"
#include "mesh/gltf/extensions.hpp"
#include "mesh/gltf/tinygltf.hpp"

namespace warpjet {

// `bytes` is a view into the file, into the caller's files or into what was decoded, of that
// length.
struct Buffer {
  std::string uri;
  std::uint64_t length = 0;
  bool isFallback = false;  // for readers without the compression: its bytes may be missing
  Bytes bytes;
};

// Where compressed bytes are: in a view, or in a primitive (by mesh and place) if `view` is -1.
struct PackedPlace {
  int view = -1;
  std::pair<std::size_t, std::size_t> primitive{};
  bool isUnpacked = false;
};

// The model has no buffers, and its images have no bytes. No index in it has been followed yet.
struct Gltf {
  tinygltf::Model model;
  Extensions extensions;
  std::vector<Buffer> buffers;
  std::vector<PackedPlace> packed;
  std::map<int, std::vector<std::uint8_t>> unpackedViews;  // by bufferView
  std::uint64_t unpackedBytes = 0;
  std::vector<std::vector<std::uint8_t>> decoded;
  std::vector<std::string> warnings;

  // Adds a sentence once. No number of the file may be in it, or there would be as many as a
  // stranger likes, each compared with all.
  void warn(const std::string& sentence);
};

// From the description alone: the buffers have no bytes yet. Refuses required extensions by name.
// Throws a FileProblem.
Gltf describedGltf(std::string_view json);

// Finds the bytes of all buffers; the first may be the binary chunk. Throws a FileProblem.
void findBuffers(Gltf& gltf, std::optional<Bytes> binary, const Files& files);

// The part of a buffer that `what` reads. Throws a FileProblem if there is no such part.
Bytes bytesOfBuffer(const Gltf& gltf, const std::string& what, int buffer, std::uint64_t offset,
                    std::uint64_t length);

// The part of a buffer that a view shows, or what was unpacked of it. Throws likewise.
Bytes bytesOfView(const Gltf& gltf, int bufferView);

// "accessor", 3, how many there are → the element's place, or a FileProblem.
std::size_t checkedIndex(const char* what, int index, std::size_t count);

}  // namespace warpjet
