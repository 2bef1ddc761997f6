// The words of the language, which nobody can take for a name.
#pragma once

#include <string_view>

namespace warpjet::glsl {

bool isKeyword(std::string_view name);

}  // namespace warpjet::glsl
