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

// The first problem of a source. After a problem, the parser reads only end tokens, so it stops by
// itself; only loops have to test `any`.
class Problems {
 public:
  void add(Location location, std::string message) {
    if (!found_) found_ = {location, std::move(message)};
  }

  // Adds a problem that `restore` keeps, in place of one that it would forget.
  void addFinal(Location location, std::string message) {
    if (isFinal_) return;
    found_ = {location, std::move(message)};
    isFinal_ = true;
  }

  bool any() const { return found_.has_value(); }

  // Forgets the problem that was found since `before`, since the same code is lowered otherwise.
  void restore(const Problems& before) {
    if (!isFinal_) *this = before;
  }

  // Returns the message with line and column, then the line itself and a caret under the location.
  std::string message(std::string_view source) const;

 private:
  struct Found {
    Location location;
    std::string message;
  };

  std::optional<Found> found_;
  bool isFinal_ = false;
};

// A source with '\n' at all line ends. `lines` has its lines unchanged. In `joined`, each line that
// ends with a backslash is joined to the next one, at the positions `joins`.
struct Lines {
  explicit Lines(std::string_view text);

  std::string lines, joined;
  std::vector<std::size_t> joins;
};

// Quotes a piece of the source for a message: on one line, shortened, without control characters.
std::string quote(std::string_view piece);

}  // namespace warpjet::source
