// From a text to its tokens: names, numbers and symbols, each with its place. Comments are gone.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "glsl/source.hpp"

namespace warpjet::glsl {

struct Token {
  // Other is what GLSL has no token for: an error unless a directive skips it.
  enum class Kind : std::uint8_t { Name, Int, Uint, Float, Symbol, Other, End };

  Kind kind = Kind::End;
  bool startsLine = false, followsSpace = false;
  std::string_view text;
  Location place;
  // Whether it names a macro that was met within itself, and so names none any more.
  bool isPlain = false;
  // The line where the call ends that this token is expanded from; 0 if it is from no macro.
  std::uint32_t callLine = 0;

  bool is(std::string_view wanted) const {
    return (kind == Kind::Symbol || kind == Kind::Name) && text == wanted;
  }
};

// The last is an End. The texts of the tokens are parts of `source`, whose lines end by '\n'. At
// each of the `joins`, in ascending order, two lines of the text were joined by a backslash.
std::vector<Token> readTokens(std::string_view source, Problems& problems,
                              std::span<const std::size_t> joins = {});

// Why a token of the kind Other cannot be read.
std::string problemOf(const Token& other);

// Of a number's token.
std::uint32_t intValue(const Token& token, Problems& problems);
double floatValue(const Token& token);

}  // namespace warpjet::glsl
