// The scalar types, with the suffix of their vectors: vec3f.
#pragma once

#include <array>
#include <string_view>

#include "source/types.hpp"

namespace warpjet::source::wgsl {

struct ScalarName {
  std::string_view word;
  char suffix;
  Type type;
};
inline constexpr std::array scalarNames{
    ScalarName{"f32", 'f', floatType}, ScalarName{"i32", 'i', intType},
    ScalarName{"u32", 'u', uintType}, ScalarName{"bool", '\0', boolType}};

}  // namespace warpjet::source::wgsl
