// Shared by the two versions of GLSL ES.
#pragma once

#include "emit/dialect.hpp"

namespace warpjet::glsl {

// The default precision of integers in a fragment shader is mediump, 16 bits.
inline constexpr std::array<std::string_view, ops::typeCount> numbers{"float", "bool", "highp int"};
inline constexpr std::array<std::array<std::string_view, 3>, ops::typeCount> vectors{
    {{"vec2", "vec3", "vec4"}, {"bvec2", "bvec3", "bvec4"}, {"ivec2", "ivec3", "ivec4"}}};
// The default precision of samplers is lowp, which truncates height values.
inline constexpr std::string_view image = "highp sampler2D";

inline constexpr std::string_view declaration = "$0 $1", definition = "$0 $1 = ",
                                  loop = "for (int $0 = 0; $0 < $1; $0++) {\n",
                                  construction = "$0($1)", splat = "$0($1)",
                                  function = "$0 $1($2) {\n", parameter = "$0 $1",
                                  structure = "struct $0 {$1 };\n", member = " $0 $1;";

// Version 1.00 needs the extension OES_standard_derivatives; our JavaScript never fades noise for
// it.
inline constexpr std::string_view across = R"(highp float warpjetAcross(highp float x) {
  return dFdx(x);
}
)";
inline constexpr std::string_view down = R"(highp float warpjetDown(highp float x) {
  return dFdy(x);
}
)";

// The limit of WebGL 1.0, section 6.21; WebGL 2 allows 1024, but a warp should compile for both.
inline constexpr std::size_t maxNameLength = 256;

}  // namespace warpjet::glsl
