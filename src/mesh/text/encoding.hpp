// Converts text files in other encodings to UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/files.hpp"

namespace warpjet {

inline constexpr std::string_view utf8Mark = "\xEF\xBB\xBF";

// Returns the whole file as text.
std::string_view textOf(Bytes bytes);

// Converts a UTF-16 file to UTF-8; nullopt for any other file. Its byte order mark determines the
// byte order; a file without a mark is taken for UTF-16 if its first two characters are ASCII.
// Unpaired surrogates become U+FFFD.
std::optional<std::string> utf8OfUtf16(Bytes bytes);

}  // namespace warpjet
