// The grammar of an expression in a C-like shading language, as far as it decides whether a text
// can stand where an operand is expected.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace warpjet {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isWordStart(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
constexpr bool isWordPart(char c) { return isWordStart(c) || isDigit(c); }

inline std::string quoted(std::string_view text) { return '"' + std::string(text) + '"'; }

// The operators that not every language has; << and >> go with &.
inline constexpr std::string_view allOperators = "%&|^~?:";

// Why a text is not one complete expression, or nothing. `operators` are those of
// `allOperators` that the language has.
std::string syntaxProblem(std::string_view text, std::string_view operators);

// The numbers, words, brackets and operators of a complete expression.
std::vector<std::string_view> tokensOf(std::string_view text);

// The identifiers in a text. Members behind a dot are not among them.
std::vector<std::string_view> identifiers(std::string_view text);

}  // namespace warpjet
