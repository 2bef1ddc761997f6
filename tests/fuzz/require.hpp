// Checks that must hold for any bytes. If one fails, the program ends, and libFuzzer saves the
// bytes.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace warpjet {

inline void require(bool holds, std::string_view what, const std::string& actual = {}) {
  if (holds) return;
  std::fprintf(stderr, "NOT TRUE: %.*s; %s\n", static_cast<int>(what.size()), what.data(),
               actual.c_str());
  std::abort();
}

// Returns a number with all its digits.
inline std::string printExactly(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace warpjet
