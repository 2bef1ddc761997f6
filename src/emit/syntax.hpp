// The grammar of an expression in a C-like shading language, as far as it decides whether a text
// can stand where an operand is expected.
#pragma once

#include <string>
#include <string_view>

namespace warpjet {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isWordStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool isWordPart(char c) { return isWordStart(c) || isDigit(c); }

inline std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

// Why a text is not one complete expression, or nothing. `operators` are those of `%&|^~?:` that
// the language has; << and >> go with &.
std::string syntaxProblem(std::string_view text, std::string_view operators);

}  // namespace warpjet
