// Pieces of the sentences about files and meshes, and how a sentence travels inside the loader.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace warpjet {

// What a file does wrong. Thrown by the parts of the loader, since a fault may lie deep within a
// file, and caught by loadMesh, which puts its name before it.
struct FileProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// With commas between groups of three digits: 1,204.
std::string grouped(std::uint64_t number);

// A text from outside, on one line, of printable ASCII and not too long, in quotation marks.
std::string quotedText(std::string_view text);

}  // namespace warpjet
