// The front end of GLSL ES 1.00 and 3.00.
#pragma once

#include <string_view>

#include "source/source.hpp"

namespace warpjet::source::glsl {

Parsed parse(std::string_view source);

}  // namespace warpjet::source::glsl
