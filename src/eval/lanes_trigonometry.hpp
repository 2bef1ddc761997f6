// Sine, cosine and tangent for four floats at a time, accurate to 2 units in the last place for
// every finite float; NaN for infinities.
//
// x = hπ + r with |r| <= π/2, where h is an integer for the sine and half an odd integer for the
// cosine, so that either is ± sin(r): one polynomial, no branch. π is split into four parts, and
// the first three have so few bits that their products with h are exact (W. J. Cody and W. Waite,
// Software Manual for the Elementary Functions, 1980, chapter 8): r remains accurate close to
// multiples of π. Beyond `sineLimit`, h has too many bits, and each lane is computed separately in
// double.
#pragma once

#include <cmath>

#include "eval/lanes_rounding.hpp"
#include "eval/wide_lanes.hpp"

namespace warpjet {

// Up to this limit, 2h is below 2^13, and a part of π has 11 bits.
inline constexpr double sineLimit = 12800;

// Adding this constant puts the nearest integer into the lowest bits.
inline constexpr double roundToLowBits = 0x1.8p23;

// Returns x - hπ. The last two products are added first, and the rounding error of their sum is
// subtracted, too. So only one rounding matters; if they were subtracted one by one, two would.
template <FourLanes X>
X minusMultipleOfPi(X x, X h) {
  const X reduced = x - h * 0x1.92p1 - h * 0x1.fb4p-11;
  const X third = h * 0x1.444p-23, fourth = h * 0x1.68c234c4c6629p-38;
  const X sum = third + fourth, rest = (third - sum) + fourth;
  return (reduced - sum) - rest;
}

// Returns sin(r) for |r| <= π/2. The relative error is below 2^-26: the coefficients are those of
// the minimax polynomial (2^-27.2), adjusted by a search for the min error with float rounding,
// which would otherwise exceed 2 units close to π/2.
template <FourLanes X>
X sineOfReduced(X r) {
  const X t = r * r;
  const X p = polynomial(t, {-0x1.55554ep-3, 0x1.110ee8p-7, -0x1.9f6f96p-13, 0x1.5da592p-19});
  return r + r * t * p;
}

// Returns a mask of sign bits, set where `multiple` of π is odd, which flips the sine. The multiple
// is the lowest bits of its float; all but the last bit are shifted out.
template <FourLanes X>
typename X::Mask signOfOdd(X multiple) {
  return {asMask(multiple).bits << 31};
}

// Returns the sine of a magnitude up to sineLimit.
template <FourLanes X>
X sineUpToLimit(X magnitude) {
  const X shifted = magnitude * 0x1.45f306dc9c883p-2 + roundToLowBits;
  const X r = minusMultipleOfPi(magnitude, X(shifted - roundToLowBits));
  return flipSign(sineOfReduced(r), signOfOdd(shifted));
}

// Returns the cosine of a magnitude up to sineLimit: cos(r + (k - 1/2)π) = (-1)^k sin(r).
template <FourLanes X>
X cosineUpToLimit(X magnitude) {
  const X shifted = magnitude * 0x1.45f306dc9c883p-2 + 0.5 + roundToLowBits;
  const X r = minusMultipleOfPi(magnitude, X(shifted - roundToLowBits - 0.5));
  return flipSign(sineOfReduced(r), signOfOdd(shifted));
}

// Replaces lanes beyond the limit by f of the lane. The others are unchanged, so that no lane
// depends on its neighbors.
template <class Function>
[[gnu::noinline, gnu::cold]] Lanes replaceLanesBeyond(Mask beyond, Lanes results, Lanes x,
                                                      Function f) {
  for (std::size_t i = 0; i < Lanes::count; ++i) {
    if (beyond.bits[i]) results.set(i, static_cast<float>(f(static_cast<double>(x[i]))));
  }
  return results;
}

inline Lanes sin(Lanes x) {
  const Lanes magnitude = abs(x), results = flipSign(sineUpToLimit(magnitude), signOf(x));
  const Mask beyond = logicalNot(le(magnitude, sineLimit));
  if (!any(beyond)) return results;
  return replaceLanesBeyond(beyond, results, x, [](double angle) { return std::sin(angle); });
}

inline Lanes cos(Lanes x) {
  const Lanes magnitude = abs(x), results = cosineUpToLimit(magnitude);
  const Mask beyond = logicalNot(le(magnitude, sineLimit));
  if (!any(beyond)) return results;
  return replaceLanesBeyond(beyond, results, x, [](double angle) { return std::cos(angle); });
}

inline constexpr double tangentLimit = 0x1p20;

[[gnu::noinline]] inline Lanes tan(Lanes x) {
  constexpr double roundToInteger = 0x1.8p52;
  const WideLanes wide(x), shifted = wide * 0x1.45f306dc9c883p-1 + roundToInteger,
                           k = shifted - roundToInteger;
  const WideLanes r = wide - k * 0x1.921fb544p0 - k * 0x1.0b4611a626331p-34, t = r * r;
  // Minimax polynomials up to π/4 with relative errors below 2^-27.2 and 2^-33.
  const WideLanes sine =
      r * (t * polynomial(t, {-0.16666654670686726, 0.00833210070875799, -0.0001950392976145408}) +
           1.0);
  const WideLanes cosine = t * polynomial(t, {-0.499999997534339, 0.04166662268331677,
                                              -0.0013886682790057235, 2.437983858504944e-05}) +
                           1.0;
  const WideMask odd = -(asMask(shifted) & wideMask(1));
  const Lanes results = narrow(ifElse(odd, -cosine, sine) / ifElse(odd, sine, cosine));
  const Mask beyond = logicalNot(le(abs(x), tangentLimit));
  if (!any(beyond)) return results;
  return replaceLanesBeyond(beyond, results, x, [](double angle) { return std::tan(angle); });
}

}  // namespace warpjet
