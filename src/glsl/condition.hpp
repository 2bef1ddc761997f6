// The condition of an `#if`.
#pragma once

#include <span>

#include "glsl/macros.hpp"

namespace warpjet::glsl {

bool evaluateCondition(const Token& word, std::span<const Token> tokens, Macros& macros,
                       Problems& problems);

}  // namespace warpjet::glsl
