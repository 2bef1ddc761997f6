// Interval arithmetic: the set of values that a number can have, as a scalar type in which the rows
// of the table can be evaluated.
//
// A result contains every value of the operation for operands within their intervals, whether
// computed in double or in float32: each operation widens its result by more than float32 rounds,
// so that cancellation is accounted for as it happens, and to infinity or zero where float32
// overflows or underflows. Source of the rules: R. E. Moore, R. B. Kearfott, M. J. Cloud,
// "Introduction to Interval Analysis", 2009.
#pragma once

#include <limits>

namespace warpjet {

// The possible values of a condition.
struct Truth {
  bool canBeTrue, canBeFalse;
};

// The range from `low` to `high`, which may be infinite. A bound of zero has a sign: a range from
// 0.0 excludes -0.0, so that the inverse of a length is positive.
struct Interval {
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double low = infinity, high = -infinity;
  // True if the value may be NaN, like the root of a negative number. If it can only be NaN, the
  // interval is empty, with low > high.
  bool canBeNaN = true;

  Interval() = default;
  Interval(double x) : Interval(x, x, x != x) {}
  Interval(double from, double to, bool undefined = false)
      : low(from), high(to), canBeNaN(undefined) {}

  static Interval anything(bool canBeNaN) { return {-infinity, infinity, canBeNaN}; }

  bool isEmpty() const { return !(low <= high); }
  bool has(double x) const { return low <= x && x <= high; }
  bool isPoint() const { return low == high; }
  bool canBeInfinite() const { return low == -infinity || high == infinity; }
};

// The relative amount by which an operation widens its result: two roundings of float32.
inline constexpr double rounding = 0x1p-23;

// Returns the smallest interval that contains both.
Interval join(const Interval& x, const Interval& y);

// Accounts for the range of float32: too large values become infinite, too small ones may become
// zero.
Interval withFloat32(const Interval& x);

// Applies a monotonically increasing function that maps NaN to NaN; the result is widened by the
// relative error that functions may have in shaders (see interval_parts.hpp). Not inlined: a copy
// for each function made the code of this module a third larger.
[[gnu::noinline]] Interval increasing(double (*function)(double), const Interval& x,
                                      double relativeError = 8 * rounding);

// Restricts a value that is known to be between two numbers.
Interval clipTo(const Interval& x, double low, double high);

Interval operator-(const Interval& x);
Interval operator+(const Interval& x, const Interval& y);
Interval operator-(const Interval& x, const Interval& y);
Interval operator*(const Interval& x, const Interval& y);
Interval operator/(const Interval& x, const Interval& y);
// Returns x * x, which is never negative.
Interval square(const Interval& x);

Interval pow(const Interval& x, const Interval& y);
Interval sqrt(const Interval& x);
Interval inversesqrt(const Interval& x);
Interval exp(const Interval& x);
Interval exp2(const Interval& x);
Interval log(const Interval& x);
Interval log2(const Interval& x);

Interval sin(const Interval& x);
Interval cos(const Interval& x);
Interval tan(const Interval& x);
Interval asin(const Interval& x);
Interval acos(const Interval& x);
Interval atan(const Interval& x);
Interval atan2(const Interval& y, const Interval& x);
Interval sinh(const Interval& x);
Interval cosh(const Interval& x);
Interval tanh(const Interval& x);
Interval asinh(const Interval& x);
Interval acosh(const Interval& x);
Interval atanh(const Interval& x);

Interval abs(const Interval& x);
Interval sign(const Interval& x);
Interval floor(const Interval& x);
Interval ceil(const Interval& x);
Interval round(const Interval& x);
Interval trunc(const Interval& x);
Interval fract(const Interval& x);
Interval mod(const Interval& x, const Interval& y);
Interval min(const Interval& x, const Interval& y);
Interval max(const Interval& x, const Interval& y);
Interval mix(const Interval& x, const Interval& y, const Interval& amount);
Interval step(const Interval& edge, const Interval& x);
Interval hash(const Interval& h, const Interval& i);

Truth lt(const Interval& x, const Interval& y);
Truth le(const Interval& x, const Interval& y);
Truth eq(const Interval& x, const Interval& y);
inline Truth gt(const Interval& x, const Interval& y) { return lt(y, x); }
inline Truth ge(const Interval& x, const Interval& y) { return le(y, x); }

inline Truth logicalNot(Truth x) { return {x.canBeFalse, x.canBeTrue}; }
inline Truth logicalAnd(Truth x, Truth y) {
  return {x.canBeTrue && y.canBeTrue, x.canBeFalse || y.canBeFalse};
}
inline Truth logicalOr(Truth x, Truth y) {
  return {x.canBeTrue || y.canBeTrue, x.canBeFalse && y.canBeFalse};
}
inline Truth ne(const Interval& x, const Interval& y) { return logicalNot(eq(x, y)); }

Interval ifElse(Truth condition, const Interval& yes, const Interval& no);

}  // namespace warpjet
