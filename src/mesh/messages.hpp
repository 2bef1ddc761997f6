// Parts of the messages about files and meshes, and the exception that carries a message inside the
// loader.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace warpjet {

// A problem with a file. The parts of the loader throw it, since an error may be deep inside of a
// file; loadMesh catches it, and puts its own name before the message.
struct FileProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Groups digits by commas: 1,204.
std::string groupDigits(std::uint64_t number);

// Quotes a text from outside: printable ASCII, on one line, shortened.
std::string quoteText(std::string_view text);

}  // namespace warpjet
