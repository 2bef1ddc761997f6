// What of a compressed part of a glTF leaves for its decoder, and comes back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/files.hpp"

namespace warpjet {

// A part that drawing needs. `plan` is JSON for whoever decodes it:
// { codec: "meshopt", extension, isOptional, count, byteStride, mode, filter } or
// { codec: "draco", extension, isOptional, attributes: [{ id, componentType, width }] }.
// What is optional has a plain form in the file, too.
struct PackedPart {
  Bytes bytes;
  std::string plan;
};

// One piece of decoded bytes, or for Draco the indices as integers of 32 bits, three a triangle,
// and then the numbers of each attribute in the order and the type of the plan.
using Pieces = std::vector<std::vector<std::uint8_t>>;

}  // namespace warpjet
