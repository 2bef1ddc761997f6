// Suggests the name that an unknown name was meant to be.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::source {

// Takes candidate names, and keeps the one with the smallest edit distance: insertions, deletions,
// changes, and swaps of adjacent letters.
class Nearest {
 public:
  explicit Nearest(std::string_view name);
  void offer(std::string_view name);

  // Returns "; did you mean sin?", for example; empty if no candidate is close.
  std::string question() const;

 private:
  std::string_view name_, found_;
  std::size_t limit_;
};

}  // namespace warpjet::source
