// Evaluates the condition of an `#if`, and the numbers of a `#line`. `directive` is the token `if`,
// `elif` or `line`, for messages and their locations.
#pragma once

#include <optional>
#include <span>

#include "source/glsl/macros.hpp"

namespace warpjet::source::glsl {

bool evaluateCondition(const Token& directive, std::span<const Token> tokens, Macros& macros,
                       Problems& problems);

// The number of the next line and, if present, that of the file.
struct LineNumbers {
  std::int32_t line = 0;
  std::optional<std::int32_t> file{};
};
LineNumbers evaluateLine(const Token& directive, std::span<const Token> tokens, Macros& macros,
                         Problems& problems);

}  // namespace warpjet::source::glsl
