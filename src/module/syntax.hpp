// The grammar of expressions in C-like shading languages, as far as needed to decide whether a text
// can be used as an operand.
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

inline std::string quote(std::string_view text) { return '"' + std::string(text) + '"'; }

// The operators that some languages lack. << and >> are available together with &.
inline constexpr std::string_view optionalOperators = "%&|^~?:";

// Returns why a text is not one complete expression; empty if it is. `operators` is the subset of
// `optionalOperators` that the language has.
std::string syntaxProblem(std::string_view text, std::string_view operators);

// Returns the numbers, words, brackets and operators of a complete expression.
std::vector<std::string_view> tokensOf(std::string_view text);

// Returns the identifiers in a text, without members after a dot.
std::vector<std::string_view> identifiers(std::string_view text);

}  // namespace warpjet
