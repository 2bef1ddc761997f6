// From a text to its tokens: names, numbers and symbols, each with its place. Comments and lines
// that go on after a backslash are gone.
#pragma once

#include <string_view>
#include <vector>

#include "glsl/source.hpp"

namespace warpjet::glsl {

struct Token {
  enum class Kind : std::uint8_t { Name, Int, Uint, Float, Symbol, End };

  Kind kind = Kind::End;
  bool startsLine = false, followsSpace = false;
  std::string_view text;
  Location place;
  // Whether it names a macro that was met within itself, and so names none any more.
  bool isPlain = false;

  bool is(std::string_view wanted) const {
    return (kind == Kind::Symbol || kind == Kind::Name) && text == wanted;
  }
};

// The last is an End. The texts of the tokens are parts of `source`.
std::vector<Token> readTokens(std::string_view source, Problems& problems);

// Of a number's token.
std::uint32_t intValue(const Token& token, Problems& problems);
double floatValue(const Token& token, Problems& problems);

}  // namespace warpjet::glsl
