// Mutates glTF files so that most remain readable, which changes of single bytes don't achieve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace warpjet {

using FileBytes = std::vector<std::uint8_t>;

// Changes some bytes; the result has at most that many.
using MutateBytes = std::function<void(FileBytes&, std::size_t maxSize)>;

// Returns another file of at most `maxSize` bytes. For a GLB, changes either the description or the
// binary chunk and updates the lengths in its headers; for a .gltf, changes the description.
// Descriptions are changed as JSON trees, or as text. Some files, and all other formats, are
// changed byte by byte.
FileBytes mutatedFile(FileBytes file, std::size_t maxSize, unsigned seed,
                      const MutateBytes& mutate);

}  // namespace warpjet
