// Hyperbolic functions and their inverses for four floats at a time.
#pragma once

#include "eval/lanes_exponentials.hpp"

namespace warpjet {

// Uses a minimax polynomial up to 1, where e^x - e^-x would cancel. Its relative error is below
// 2^-31.6.
[[gnu::noinline]] inline Lanes sinh(Lanes x) {
  const Lanes magnitude = abs(x), t = x * x;
  const Lanes p = polynomial(t, {0x1.555556p-3, 0x1.1110ep-7, 0x1.a022bcp-13, 0x1.756c1ep-19});
  const Lanes half = expTimesPowerOf2(magnitude, -1);  // half of e^|x|, which may be infinite
  const Lanes large = half - 0.25 / half, small = magnitude + magnitude * t * p;
  return flipSign(ifElse(gt(magnitude, 1.0), large, small), signOf(x));
}

[[gnu::noinline]] inline Lanes cosh(Lanes x) {
  const Lanes half = expTimesPowerOf2(abs(x), -1);
  return half + 0.25 / half;
}

// Uses a minimax polynomial up to 0.625. Its relative error is below 2^-27.7.
[[gnu::noinline]] inline Lanes tanh(Lanes x) {
  const Lanes magnitude = abs(x), t = x * x;
  const Lanes p =
      polynomial(t, {-0x1.555532p-2, 0x1.1106f6p-3, -0x1.b835a4p-5, 0x1.51f8cep-6, -0x1.750ce2p-8});
  const Lanes large = 1.0 - 2.0 / (exp(2.0 * magnitude) + 1.0);
  const Lanes small = magnitude + magnitude * t * p;
  return flipSign(ifElse(gt(magnitude, 0.625), large, small), signOf(x));
}

// The logarithms are computed in double, but leading digits cancel for small results: below this
// limit, two terms of the Taylor series are accurate enough for a float.
inline constexpr double smallHyperbolic = 0x1p-12;

[[gnu::noinline]] inline Lanes asinh(Lanes x) {
  const Lanes magnitude = abs(x);
  const WideLanes wide(magnitude);
  const Lanes large = narrow(logOfPositive(wide + sqrt(wide * wide + 1.0)));
  const Lanes small = magnitude - magnitude * (x * x) * (1.0 / 6);
  const Lanes finite = ifElse(lt(magnitude, smallHyperbolic), small, large);
  return flipSign(ifElse(lt(magnitude, infinity), finite, magnitude), signOf(x));
}

[[gnu::noinline]] inline Lanes acosh(Lanes x) {
  const WideLanes wide(x);
  const Lanes finite = narrow(logOfPositive(wide + sqrt(wide * wide - 1.0)));
  const Lanes specialValue = ifElse(ge(x, 1.0), x, notANumber);
  return ifElse(logicalAnd(ge(x, 1.0), lt(x, infinity)), finite, specialValue);
}

[[gnu::noinline]] inline Lanes atanh(Lanes x) {
  const Lanes magnitude = abs(x);
  const WideLanes wide(magnitude);
  const Lanes large = narrow(0.5 * logOfPositive((1.0 + wide) / (1.0 - wide)));
  const Lanes small = magnitude + magnitude * (x * x) * (1.0 / 3);
  const Lanes inside = ifElse(lt(magnitude, smallHyperbolic), small, large);
  const Lanes outside = ifElse(eq(magnitude, 1.0), infinity, notANumber);
  return flipSign(ifElse(lt(magnitude, 1.0), inside, outside), signOf(x));
}

}  // namespace warpjet
