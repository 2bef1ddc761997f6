// The words and operators that each shading language keeps for itself. So far the languages differ
// in nothing else that is written here.
#pragma once

#include <string>
#include <string_view>

namespace warpjet {

struct Dialect {
  std::string_view name;
  bool hasBitOperators;
  // Lists are separated by spaces, with a space at both ends.
  std::string_view constructors;  // types whose name an expression may call
  std::string_view builtIns;      // variables of the language that an expression may read
  std::string_view keywords;      // these, and all words reserved for later

  static bool holds(std::string_view list, std::string_view word) {
    return list.find(' ' + std::string(word) + ' ') != list.npos;
  }
};

extern const Dialect glsl300;
extern const Dialect glsl100;

// The dialect of that name, or null.
const Dialect* findDialect(std::string_view name);

}  // namespace warpjet
