// Mutates glTF files so that most remain readable, which changes of single bytes don't achieve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace warpjet {

using FileBytes = std::vector<std::uint8_t>;

// Changes some bytes; the result has at most `maxSize` bytes.
using MutateBytes = std::function<void(FileBytes&, std::size_t maxSize)>;

// Returns a changed file of at most `maxSize` bytes. In a GLB, changes either the JSON or the
// binary chunk, and updates the lengths in the headers; in a .gltf, changes the JSON. Changes JSON
// as a tree, or as text. Changes single bytes in some files, and in all files of other formats.
FileBytes mutateFile(FileBytes file, std::size_t maxSize, unsigned seed, const MutateBytes& mutate);

}  // namespace warpjet
