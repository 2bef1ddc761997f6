// Locations in a source, and problems at them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace warpjet::source {

// Lines and columns count from 1. `shown` is the line number adjusted by `#line`.
struct Location {
  std::uint32_t line = 1, column = 1, shown = 1;
};

// The first problem of a source. After a problem, the parser only sees the end of the source, so
// that only loops need to check for it.
class Problems {
 public:
  void add(Location place, std::string message) {
    if (!found_) found_ = {place, std::move(message)};
  }

  bool any() const { return found_.has_value(); }

  // The message with line and column, then the line itself and a caret under the location.
  std::string text(std::string_view source) const;

 private:
  struct Found {
    Location place;
    std::string message;
  };

  std::optional<Found> found_;
};

// The source in normalized form: lines end with '\n' only, and each line that ends with a backslash
// is joined to the next one, at the positions `joins` of `joined`.
struct Lines {
  explicit Lines(std::string_view text);

  std::string separate, joined;
  std::vector<std::size_t> joins;
};

// Quotes a piece of the source for a message: on one line, shortened, without control characters.
std::string quoted(std::string_view piece);

}  // namespace warpjet::source
