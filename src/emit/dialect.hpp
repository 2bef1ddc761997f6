// What differs between shading languages, and the names that each of them keeps for itself.
#pragma once

#include <string_view>

namespace warpjet {

struct Dialect {
  std::string_view name;
  // Keywords and words reserved for later, separated by spaces, with a space at both ends.
  std::string_view keywords;
};

extern const Dialect glsl300;
extern const Dialect glsl100;

// The dialect of that name, or null.
const Dialect* findDialect(std::string_view name);

}  // namespace warpjet
