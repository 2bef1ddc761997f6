// THE table of the built-in functions of GLSL.
#pragma once

#include <string_view>

#include "source/builtins.hpp"

namespace warpjet::source::glsl {

extern const BuiltIns builtIns;

// Its name in the table of versions if both languages have a function of its name; empty otherwise.
std::string_view builtInFeature(const BuiltIn& row);

}  // namespace warpjet::source::glsl
