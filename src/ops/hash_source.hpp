// The source of the hash function in each language.
#pragma once

#include <algorithm>

#include "ops/row.hpp"

namespace warpjet::ops {

// Computes hashOf of scalar.hpp, in integers if the language has them. Adding 4091 * 262144 makes a
// negative `i` positive, where GLSL's % is defined. In floats, the rounded quotient may leave a
// remainder that is up to 5 below 0 or above 4091, if division is accurate to 2.5 ulp. Products of
// two such remainders, at most 2^24, are exact as well, so only the last remainder needs
// correction.
inline constexpr Helpers hashHelpers{
    R"(highp float warpjetHash(highp float h, highp float i) {
  highp uint n = (1597u * (uint(h) + uint(int(floor(i)) + 1072431104) % 4091u) + 823u) % 4091u;
  return float(n * n % 4091u * n % 4091u);
}
)",
    R"(highp float warpjetRemainder(highp float x) {
  return x - 4091.0 * floor(x / 4091.0);
}
highp float warpjetHash(highp float h, highp float i) {
  highp float n = warpjetRemainder(1597.0 * (floor(h) + warpjetRemainder(floor(i))) + 823.0);
  highp float r = warpjetRemainder(warpjetRemainder(n * n) * n);
  return r < 0.0 ? r + 4091.0 : r < 4091.0 ? r : r - 4091.0;
}
)",
    R"(fn warpjetHash(h: f32, i: f32) -> f32 {
  let n = (1597u * (u32(h) + u32(i32(floor(i)) + 1072431104) % 4091u) + 823u) % 4091u;
  return f32(n * n % 4091u * n % 4091u);
}
)"};
static_assert(std::none_of(hashHelpers.begin(), hashHelpers.end(),
                           [](std::string_view source) { return source.empty(); }),
              "each language needs a source");

}  // namespace warpjet::ops
