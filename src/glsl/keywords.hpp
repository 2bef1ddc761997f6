// The words of a language, which nobody can take for a name.
#pragma once

#include <string_view>

namespace warpjet::glsl {

// In a text of that version; one without, 0, has those of both.
bool isKeyword(std::string_view name, int version);

}  // namespace warpjet::glsl
