// The data that is exchanged with the decoder of a compressed part of a glTF.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/files.hpp"

namespace warpjet {

// A part that drawing needs. `plan` is JSON for the decoder:
// { codec: "meshopt", extension, isOptional, count, byteStride, mode, filter } or
// { codec: "draco", extension, isOptional, attributes: [{ id, componentType, width }] }.
// An optional part has an uncompressed form in the file, too.
struct PackedPart {
  Bytes bytes;
  std::string plan;
};

// The decoded bytes. Meshopt: one piece. Draco: a piece with the indices, 32-bit integers, three
// per triangle, followed by a piece per attribute, with numbers in the order and type of the plan.
using Pieces = std::vector<std::vector<std::uint8_t>>;

}  // namespace warpjet
