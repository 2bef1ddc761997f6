// What was meant by a name that is not there.
#pragma once

#include <string>
#include <string_view>

namespace warpjet::glsl {

// Is offered names, and keeps the one that is fewest letters away: to put in, take out, change or
// swap with the next.
class Nearest {
 public:
  explicit Nearest(std::string_view name);
  void offer(std::string_view name);

  // "; did you mean sin?", or nothing if none is near.
  std::string question() const;

 private:
  std::string_view name_, found_;
  std::size_t least_;
};

}  // namespace warpjet::glsl
