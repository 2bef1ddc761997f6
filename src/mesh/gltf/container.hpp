// The outer structure of a GLB: its two chunks.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "mesh/files.hpp"

namespace warpjet {

// The description of a glTF and, in a GLB, the embedded buffer. Both are views into the file.
struct Chunks {
  std::string_view json;
  std::optional<Bytes> binary;
};

// "JSON" and "BIN\0", glTF 2.0, section 4.4.3.
constexpr std::uint32_t jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;

// Splits a GLB; see glTF 2.0, section 4.4. Ignores chunks after the first two, as the specification
// requires. Throws a FileProblem.
Chunks chunksOfGlb(Bytes bytes);

}  // namespace warpjet
