// Where something stands in a text, and what is wrong there.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace warpjet::glsl {

// Lines and columns count from 1. `shown` is the line's number as `#line` has it.
struct Location {
  std::uint32_t line = 1, column = 1, shown = 1;
};

// The first problem of a text. Whoever reads on after one finds the end at once, so that nothing
// needs to ask for it but loops.
class Problems {
 public:
  void add(Location place, std::string sentence) {
    if (!found_) found_ = {place, std::move(sentence)};
  }

  bool any() const { return found_.has_value(); }

  // The sentence with its line and column, then the line itself and a caret under the place.
  std::string text(std::string_view source) const;

 private:
  struct Found {
    Location place;
    std::string sentence;
  };

  std::optional<Found> found_;
};

// A text as it is read: its lines end by '\n' alone, and each that ends by a backslash is joined to
// the next, at the places `joins` of `joined`.
struct Lines {
  explicit Lines(std::string_view text);

  std::string separate, joined;
  std::vector<std::size_t> joins;
};

// A piece of the text for a sentence: on one line, not too long, without what a terminal obeys.
std::string quoted(std::string_view piece);

}  // namespace warpjet::glsl
