// Splits a source into tokens: names, numbers and symbols with their locations. Comments are
// removed.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "source/problems.hpp"

namespace warpjet::source::glsl {

struct Token {
  // Other is an invalid token: an error unless a directive skips it.
  enum class Kind : std::uint8_t { Name, Int, Uint, Float, Symbol, Other, End };

  Kind kind = Kind::End;
  bool startsLine = false, followsSpace = false;
  std::string_view text;
  Location location;
  // True for the name of a macro within that macro's own expansion, which is never expanded.
  bool isPlain = false;
  // The last line of the macro call that this token was expanded from; 0 if there is none.
  std::uint32_t callLine = 0;

  bool is(std::string_view wanted) const {
    return (kind == Kind::Symbol || kind == Kind::Name) && text == wanted;
  }
};

// Reads the tokens; the last one is an End. The text of tokens refers to `source`, whose lines end
// with '\n'. At each of the positions `joins`, in ascending order, two lines were joined by a
// backslash.
std::vector<Token> readTokens(std::string_view source, Problems& problems,
                              std::span<const std::size_t> joins = {});

// Returns the reason why a token of the kind Other is invalid.
std::string problemOf(const Token& other);

// Returns the value of a number token.
std::uint32_t intValue(const Token& token, Problems& problems);
double floatValue(const Token& token);

}  // namespace warpjet::source::glsl
