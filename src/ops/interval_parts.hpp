// Shared by the three files of interval arithmetic: interval.cpp has the arithmetic operations,
// interval_functions.cpp powers, angles and the like, interval_steps.cpp piecewise functions.
// Nothing else includes this file.
#pragma once

#include <algorithm>
#include <cmath>

#include "ops/interval.hpp"

namespace warpjet::intervals {

inline constexpr double infinity = Interval::infinity;
inline constexpr double pi = 3.14159265358979323846;

// The relative errors that divisions and functions may have in shaders, by which results are
// widened. GLSL ES 3.00 leaves them open; WGSL, section 15.7.4, has 2.5 ulp for a division and 3 to
// 4 ulp for most functions near 1.
inline constexpr double divisionError = 4 * rounding, functionError = 8 * rounding;

inline double lowerBound(double low, double relativeError) {
  return low * (low < 0 ? 1 + relativeError : 1 - relativeError);
}
inline double upperBound(double high, double relativeError) {
  return high * (high < 0 ? 1 - relativeError : 1 + relativeError);
}

inline Interval widen(double low, double high, double relativeError, bool canBeNaN) {
  return withFloat32({lowerBound(low, relativeError), upperBound(high, relativeError), canBeNaN});
}

// Lets zeros have either sign.
inline Interval withZeros(const Interval& x) {
  return {x.low == 0 ? -0.0 : x.low, x.high == 0 ? 0.0 : x.high, x.canBeNaN};
}

inline Interval emptyInterval() { return {}; }

// Clips to an interval; values outside become NaN.
inline Interval clipToDomain(const Interval& x, double low, double high) {
  const bool cut = x.low < low || x.high > high;
  return {std::max(x.low, low), std::min(x.high, high), x.canBeNaN || cut};
}

using Unary = double(double);
using Binary = double(double, double);

inline bool isNegative(double x) { return std::signbit(x); }

// Returns the hull of the values of f at the corners of a box.
inline Interval hullOfCorners(Binary f, const Interval& x, const Interval& y,
                              double relativeError) {
  const double a = f(x.low, y.low), b = f(x.low, y.high);
  const double c = f(x.high, y.low), d = f(x.high, y.high);
  const double low = std::min(std::min(a, b), std::min(c, d));
  const double high = std::max(std::max(a, b), std::max(c, d));
  return withZeros(widen(low, high, relativeError, x.canBeNaN || y.canBeNaN));
}

}  // namespace warpjet::intervals
