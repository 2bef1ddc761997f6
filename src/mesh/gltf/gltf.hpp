// A parsed glTF file: tinygltf's model of its description, and the bytes of its buffers.
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

// `bytes` refers to `length` bytes of the file, of a file of the caller, or of a decoded data URI.
struct Buffer {
  std::string uri;
  std::uint64_t length = 0;
  bool isFallback = false;  // for readers that can't decompress; its bytes may be missing
  Bytes bytes;
};

// The location of compressed bytes: in a view, or in a primitive (by mesh and index) if `view` is
// -1.
struct PackedPlace {
  int view = -1;
  std::pair<std::size_t, std::size_t> primitive{};
  bool isUnpacked = false;
};

// `model` has no buffers, its images have no bytes, and its indices have not been checked yet.
struct Gltf {
  tinygltf::Model model;
  Extensions extensions;
  std::vector<Buffer> buffers;
  std::vector<PackedPlace> packed;
  std::map<int, std::vector<std::uint8_t>> unpackedViews;  // by bufferView
  std::uint64_t unpackedBytes = 0;
  std::vector<std::vector<std::uint8_t>> decodedUris;
  std::vector<std::string> warnings;

  // Adds a warning, unless there is an equal one. The message must not contain numbers of the file:
  // otherwise a file could cause any number of warnings, each of which is compared with all others.
  void warn(const std::string& message);
};

// Parses only the description: the buffers have no bytes yet. Rejects unsupported required
// extensions by name. Throws a FileProblem.
Gltf parseDescription(std::string_view json);

// Finds the bytes of all buffers; the first one may be the binary chunk. Throws a FileProblem.
void findBuffers(Gltf& gltf, std::optional<Bytes> binary, const Files& files);

// Returns the part of a buffer that `what` reads. Throws a FileProblem if it doesn't exist.
Bytes bytesOfBuffer(const Gltf& gltf, const std::string& what, int buffer, std::uint64_t offset,
                    std::uint64_t length);

// Returns the part of a buffer that a view refers to, or its unpacked bytes. Throws a FileProblem
// if it doesn't exist.
Bytes bytesOfView(const Gltf& gltf, int bufferView);

// Returns the index of an element, such as an accessor; `what` is its name in messages. Throws a
// FileProblem if the index is not below `count`.
std::size_t checkIndex(const char* what, int index, std::size_t count);

}  // namespace warpjet
