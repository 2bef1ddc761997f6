// Splits WGSL source into tokens: names, numbers and symbols with their locations. Comments are
// removed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/problems.hpp"
#include "source/types.hpp"

namespace warpjet::source::wgsl {

struct Token {
  enum class Kind : std::uint8_t { Name, Number, Symbol, End };

  Kind kind = Kind::End;
  std::string_view text;
  Location location;

  bool is(std::string_view wanted) const {
    return (kind == Kind::Symbol || kind == Kind::Name) && text == wanted;
  }
  // Returns true if nothing is between this token and the next one.
  bool touches(const Token& next) const { return text.data() + text.size() == next.text.data(); }
};

// Reads the tokens; the last one is an End. The text of tokens refers to `source`. A `>` is always
// a token of its own, since it may end a template list: `vec2<vec2<f32>>`.
std::vector<Token> readTokens(std::string_view source, Problems& problems);

struct Number {
  Type type;
  // True if the number has no suffix, so that its type follows from its use.
  bool isAbstract;
  double value;
};

// Returns the value of a number token; nullopt, with a problem, if it is invalid.
std::optional<Number> readNumber(const Token& token, Problems& problems);

}  // namespace warpjet::source::wgsl
