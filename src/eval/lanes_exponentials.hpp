// Powers, exponentials and logarithms for four floats at a time. Denormal operands and results are
// preserved.
#pragma once

#include "eval/lanes_rounding.hpp"
#include "eval/wide_lanes.hpp"

namespace warpjet {

// Returns 2^n e^r for an integer n from -252 to 254 and |r| <= ln(2)/2. 2^n, which may exceed the
// range of floats, is the product of two factors that don't, so that an underflow is rounded once.
inline Lanes expTimesPower(Lanes r, Mask::Bits n) {
  // Minimax: e^r = 1 + r + r² p(r), with a relative error below 2^-27.8.
  const Lanes p =
      polynomial(r, {0x1.fffffcp-2, 0x1.55549p-3, 0x1.5558f8p-5, 0x1.123b04p-7, 0x1.6a22a2p-10});
  const Mask::Bits half = n >> 1;
  const Lanes scale = asLanes(Mask{(half + 127) << 23});
  const Lanes rest = asLanes(Mask{(n - half + 127) << 23});
  return (1.0 + (r + r * r * p)) * scale * rest;
}

// Adding this constant puts the nearest integer into the lowest bits, as a signed integer.
inline constexpr double roundToInt = 0x1.8p23;
inline Mask::Bits integerOf(Lanes shifted) { return asMask(shifted).bits - 0x4b400000; }

// Clamps x; NaN is preserved.
inline Lanes clampTo(Lanes x, double low, double high) { return min(max(x, low), high); }

// Returns e^x 2^power, for powers up to about 20.
inline Lanes expTimesPowerOf2(Lanes x, std::int32_t power) {
  const Lanes clamped =
      clampTo(x, -104.0, 90.0);  // beyond these limits, the result is 0 or infinite
  const Lanes shifted = clamped * 0x1.71547652b82fep0 + roundToInt;
  const Lanes n = shifted - roundToInt;
  // ln(2) in two parts; the first has 15 bits, so its product with n is exact.
  const Lanes r = clamped - n * 0x1.62e4p-1 - n * 0x1.7f7d1cf79abcap-20;
  return expTimesPower(r, integerOf(shifted) + power);
}

[[gnu::noinline]] inline Lanes exp(Lanes x) { return expTimesPowerOf2(x, 0); }

[[gnu::noinline]] inline Lanes exp2(Lanes x) {
  const Lanes clamped = clampTo(x, -152.0, 129.0);
  const Lanes shifted = clamped + roundToInt;
  return expTimesPower((clamped - (shifted - roundToInt)) * 0x1.62e42fefa39efp-1,
                       integerOf(shifted));
}

// Returns the logarithm to base 2 of finite positive numbers that aren't denormal doubles, with a
// relative error below 2^-37. x = 2^e m with m from √½ to √2, and log2(m) = s p(s²) for s = (m - 1)
// / (m + 1).
inline WideLanes log2OfPositive(WideLanes x) {
  constexpr std::int64_t rootOfHalf = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000;
  const WideMask above = asMask(x) + wideMask(one - rootOfHalf);
  const WideLanes m = asLanes((above & wideMask(0x000fffffffffffff)) + wideMask(rootOfHalf));
  // Puts the exponent's bits into the last bits of 2^52 + exponent.
  const WideMask biased = WideMask{above.low >> 52, above.high >> 52} & wideMask(0x7ff);
  const WideLanes e = asLanes(biased | wideMask(0x4330000000000000)) - (0x1p52 + 1023);
  const WideLanes s = (m - 1.0) / (m + 1.0);
  // Minimax polynomial with a relative error of 2^-37.8.
  const WideLanes p = polynomial(s * s, {2.8853900801907437, 0.9617966732654927, 0.5770836004351603,
                                         0.4116717406711723, 0.3407490634424501});
  return e + s * p;
}

inline WideLanes logOfPositive(WideLanes x) { return log2OfPositive(x) * 0x1.62e42fefa39efp-1; }

// Returns the logarithm of any x, given its value for finite positive x.
inline Lanes logarithmOf(Lanes x, Lanes finiteValue) {
  const Lanes specialValue = ifElse(eq(x, 0.0), -infinity, ifElse(gt(x, 0.0), x, notANumber));
  return ifElse(logicalAnd(gt(x, 0.0), lt(x, infinity)), finiteValue, specialValue);
}

[[gnu::noinline]] inline Lanes log2(Lanes x) {
  return logarithmOf(x, narrow(log2OfPositive(WideLanes(x))));
}
[[gnu::noinline]] inline Lanes log(Lanes x) {
  return logarithmOf(x, narrow(logOfPositive(WideLanes(x))));
}

// Returns |x|^y = 2^(y log2|x|) if neither x nor y is NaN. If the result is outside the range of
// floats, an exponent far outside is used.
inline Lanes powOfMagnitude(Lanes x, Lanes y) {
  const Lanes magnitude = abs(x), beyond = flipSign(200.0, signOf(y));
  const WideLanes exponent = log2OfPositive(WideLanes(magnitude)) * WideLanes(y);
  Lanes rounded = ifElse(eq(magnitude, 1.0), 0.0, narrow(exponent));
  rounded = ifElse(eq(magnitude, infinity), beyond, ifElse(eq(magnitude, 0.0), -beyond, rounded));
  const Mask isFar = logicalNot(lt(abs(rounded), 160.0));
  const Lanes shifted = clampTo(rounded, -160.0, 160.0) + roundToInt;
  const WideLanes rest = exponent - WideLanes(shifted - roundToInt);
  const Lanes r = narrow(rest * 0x1.62e42fefa39efp-1);
  return expTimesPower(ifElse(logicalOr(isFar, eq(magnitude, 1.0)), 0.0, r), integerOf(shifted));
}

// Agrees with std::pow, also for zeros, infinities and NaN: integer powers of negative numbers are
// real, others are NaN.
[[gnu::noinline]] inline Lanes pow(Lanes x, Lanes y) {
  const Mask whole = eq(floor(y), y), even = eq(floor(y * 0.5), y * 0.5);
  const Mask odd = {whole.bits & ~even.bits};
  const Lanes magnitude = powOfMagnitude(x, y);
  const Lanes power = flipSign(magnitude, {signOf(x).bits & odd.bits});
  const Mask isUnreal = logicalAnd(logicalAnd(lt(x, 0.0), gt(x, -infinity)), logicalNot(whole));
  const Mask isNan = logicalOr(ne(x, x), ne(y, y));
  const Lanes result = ifElse(logicalOr(isUnreal, isNan), notANumber, power);
  return ifElse(logicalOr(eq(x, 1.0), eq(y, 0.0)), 1.0, result);
}

}  // namespace warpjet
