// What people read of an operation or a composition: its name, its operands in order, and what it
// gives.
#pragma once

#include <string_view>

namespace warpjet::ops {

struct Title {
  std::string_view name;
  std::string_view operands;
  std::string_view meaning;
};

}  // namespace warpjet::ops
