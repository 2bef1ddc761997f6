// THE table of the built-in functions of GLSL.
#pragma once

#include <string_view>

#include "source/builtins.hpp"

namespace warpjet::source::glsl {

extern const BuiltIns builtIns;

// Returns the name in the table of versions of an overload that only one version has, such as "mix
// by a bvec"; empty for other functions.
std::string_view builtInFeature(const BuiltIn& row);

}  // namespace warpjet::source::glsl
