// The keywords of the language, which can't be used as names.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::source::glsl {

// Returns true for a keyword of this version of GLSL. A source without #version, for which
// `version` is 0, has the keywords of both versions.
bool isKeyword(std::string_view name, int version);

// Returns true if the word is reserved for future use.
bool isReserved(std::string_view name, int version);

// Returns the reason why this isn't a valid name; empty if it is valid.
std::string nameProblem(std::string_view name, int version);

}  // namespace warpjet::source::glsl
