// Changes glTF files in ways that keep most of them readable, which changes of single bytes do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace warpjet {

using FileBytes = std::vector<std::uint8_t>;

// Changes some bytes, to no more than so many.
using MutateBytes = std::function<void(FileBytes&, std::size_t most)>;

// Another file of no more than `most` bytes: of a GLB either the description or the binary chunk is
// changed and the lengths in its headers are put right, of a .gltf the description. Descriptions
// are changed as trees of JSON, or as text. Some of all files, and other formats always, are
// changed byte by byte.
FileBytes mutatedFile(FileBytes file, std::size_t most, unsigned seed, const MutateBytes& mutate);

}  // namespace warpjet
