// THE table of the built-in functions of WGSL. Names that no source can write are operators.
#pragma once

#include "source/builtins.hpp"

namespace warpjet::source::wgsl {

extern const BuiltIns builtIns;

}  // namespace warpjet::source::wgsl
