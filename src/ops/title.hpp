// The description of an operation or a composition: its name, its operands in order, and its
// meaning.
#pragma once

#include <string_view>

namespace warpjet::ops {

struct Title {
  std::string_view name;
  std::string_view operands;
  std::string_view meaning;
};

}  // namespace warpjet::ops
