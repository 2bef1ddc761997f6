// The outermost shape of a file: which format it is, and the two chunks of a GLB.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "mesh/files.hpp"

namespace warpjet {

// The description of a glTF and, in a GLB, the buffer that travels with it. Views into the file.
struct Chunks {
  std::string_view json;
  std::optional<Bytes> binary;
};

// "JSON" and "BIN\0", glTF 2.0, section 4.4.3.
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

enum class Format { Glb, Gltf, Obj };

// Throws a FileProblem for what is none of them.
Format formatOf(Bytes bytes);

// glTF 2.0, section 4.4. Chunks behind the first two are ignored, as it demands. Throws a
// FileProblem.
Chunks chunksOfGlb(Bytes bytes);

// The whole file as text.
std::string_view textOf(Bytes bytes);

}  // namespace warpjet
