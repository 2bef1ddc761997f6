// Arcsine, arccosine and arctangent for four floats at a time, accurate to 2 units in the last
// place.
#pragma once

#include "eval/lanes_rounding.hpp"

namespace warpjet {

// Half of π is the sum of these two; the second one is the rounding error of the float.
inline constexpr double halfPi = 0x1.921fb6p0, halfPiRest = -0x1.777a5cf72cecep-25;

// Returns asin(s) - s, given s and s², for s from 0 to 1/2. The minimax polynomial has an error
// below 2^-27.6 asin(s).
inline Lanes arcsineExcess(Lanes s, Lanes square) {
  const Lanes p = polynomial(
      square, {0x1.5555c8p-3, 0x1.3301fcp-4, 0x1.747d06p-5, 0x1.8c2d82p-6, 0x1.596d66p-5});
  return s * square * p;
}

// Above 1/2, asin(x) = π/2 - 2 asin(s) with s = √((1 - x)/2). Close to 1/2, where rounding matters
// most, π/2 - 2s is exact.
[[gnu::noinline]] inline Lanes asin(Lanes x) {
  const Lanes magnitude = abs(x);
  const Mask large = gt(magnitude, 0.5);
  const Lanes square = ifElse(large, (1.0 - magnitude) * 0.5, x * x);
  const Lanes s = ifElse(large, sqrt(square), magnitude), excess = arcsineExcess(s, square);
  const Lanes largeResult = (halfPi - 2.0 * s) - (2.0 * excess - halfPiRest);
  return flipSign(ifElse(large, largeResult, s + excess), signOf(x));
}

[[gnu::noinline]] inline Lanes acos(Lanes x) {
  const Lanes magnitude = abs(x);
  const Mask large = gt(magnitude, 0.5);
  const Lanes square = ifElse(large, (1.0 - magnitude) * 0.5, x * x);
  const Lanes s = ifElse(large, sqrt(square), x), excess = arcsineExcess(s, square);
  const Lanes fromEnd = 2.0 * (s + excess);
  const Lanes largeResult = ifElse(lt(x, 0.0), 2 * halfPi - (fromEnd - 2 * halfPiRest), fromEnd);
  return ifElse(large, largeResult, halfPi - (s + (excess - halfPiRest)));
}

// Returns the arctangent of q from 0 to 1. The minimax polynomial has a relative error below 2^-27.
inline Lanes arctangentUpToOne(Lanes q) {
  const Lanes t = q * q;
  const Lanes p =
      polynomial(t, {-0x1.55553ep-2, 0x1.9991e4p-3, -0x1.2420aep-3, 0x1.c090f6p-4, -0x1.582366p-4,
                     0x1.dab694p-5, -0x1.fef93p-6, 0x1.66171ep-7, -0x1.d74e88p-10});
  return q + q * t * p;
}

[[gnu::noinline]] inline Lanes atan(Lanes x) {
  const Lanes magnitude = abs(x);
  const Mask steep = gt(magnitude, 1.0);
  const Lanes angle = arctangentUpToOne(ifElse(steep, 1.0 / magnitude, magnitude));
  return flipSign(ifElse(steep, halfPi - (angle - halfPiRest), angle), signOf(x));
}

// Agrees with std::atan2 for zeros, infinities and signs: at (0, 0) it is 0, or π if x is -0.
[[gnu::noinline]] inline Lanes atan2(Lanes y, Lanes x) {
  const Lanes up = abs(y), along = abs(x);
  const Mask steep = gt(up, along), left = {asMask(x).bits < 0};
  const Lanes longer = ifElse(steep, up, along), shorter = ifElse(steep, along, up);
  const Lanes ratio = ifElse(eq(up, along), ifElse(eq(up, 0.0), 0.0, 1.0), shorter / longer);
  const Lanes angle = arctangentUpToOne(ratio);
  // Starts from the nearest half axis: 0, π/2 or π.
  const Lanes axis = ifElse(steep, halfPi, ifElse(left, 2 * halfPi, 0.0));
  const Lanes signedAngle = flipSign(angle, {(steep.bits ^ left.bits) & simd::signBit});
  const Lanes positive = axis + (signedAngle + axis * (halfPiRest / halfPi));
  const Lanes result = flipSign(positive, signOf(y));
  return ifElse(logicalOr(ne(x, x), ne(y, y)), notANumber, result);
}

}  // namespace warpjet
