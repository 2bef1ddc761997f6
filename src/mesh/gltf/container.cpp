#include "mesh/gltf/container.hpp"

#include <algorithm>
#include <string>

#include "mesh/messages.hpp"
#include "mesh/text/encoding.hpp"

namespace warpjet {

namespace {

constexpr std::size_t headerSize = 12;
constexpr std::size_t chunkHeaderSize = 8;

std::uint32_t littleEndian(Bytes bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

[[noreturn]] void failShort(std::uint64_t wanted, std::uint64_t got) {
  throw FileProblem("the file ends in the middle of its data (expected " + groupDigits(wanted) +
                    " bytes, got " + groupDigits(got) + "); export or download it again.");
}

// Returns the content of the chunk that starts at byte `start`.
Bytes chunkAt(Bytes bytes, std::size_t start) {
  const std::uint64_t length = littleEndian(bytes, start);
  const std::uint64_t end = start + chunkHeaderSize + length;
  if (end > bytes.size()) failShort(end, bytes.size());
  return bytes.subspan(start + chunkHeaderSize, static_cast<std::size_t>(length));
}

}  // namespace

Chunks chunksOfGlb(Bytes bytes) {
  if (bytes.size() < headerSize + chunkHeaderSize)
    failShort(headerSize + chunkHeaderSize, bytes.size());
  const std::uint32_t version = littleEndian(bytes, 4);
  if (version != 2)
    throw FileProblem("this .glb is of glTF version " + groupDigits(version) +
                      ", but only version 2 is supported; export the model as glTF 2.0.");
  const std::uint32_t length = littleEndian(bytes, 8);
  if (length > bytes.size()) failShort(length, bytes.size());
  bytes = bytes.first(length);
  if (length < headerSize + chunkHeaderSize || littleEndian(bytes, headerSize + 4) != jsonChunk)
    throw FileProblem(
        "this .glb does not start with its description (a JSON chunk); export the model again.");

  const Bytes json = chunkAt(bytes, headerSize);
  Chunks chunks{textOf(json), std::nullopt};
  // In some files, the JSON's length is not a multiple of 4, although it should be.
  const std::size_t next = headerSize + chunkHeaderSize + json.size();
  if (next + chunkHeaderSize <= bytes.size() && littleEndian(bytes, next + 4) == binaryChunk)
    chunks.binary = chunkAt(bytes, next);
  return chunks;
}

}  // namespace warpjet
