// Text files in other encodings than UTF-8.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mesh/files.hpp"

namespace warpjet {

inline constexpr std::string_view utf8Mark = "\xEF\xBB\xBF";

// The whole file as text.
std::string_view textOf(Bytes bytes);

// The text of a UTF-16 file in UTF-8, or nothing for any other file. Its byte order is that of its
// mark; a file without a mark counts as UTF-16 if its first two characters are ASCII. Halves of
// surrogate pairs become U+FFFD.
std::optional<std::string> utf8OfUtf16(Bytes bytes);

}  // namespace warpjet
