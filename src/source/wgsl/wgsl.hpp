// The front end of WGSL.
#pragma once

#include <string_view>

#include "source/source.hpp"

namespace warpjet::source::wgsl {

Parsed parse(std::string_view source);

}  // namespace warpjet::source::wgsl
