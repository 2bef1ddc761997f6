// 32-bit integers for the rows of the table. Unsigned integers are represented by the signed value
// with the same bits, since sums, products and bitwise operations are the same; operations that
// differ have two rows. All values are exact as doubles, and results wrap around.
#pragma once

#include <cmath>
#include <cstdint>

#include "ops/interval.hpp"

namespace warpjet::ops {

inline constexpr double minInt = -2147483648.0, maxInt = 2147483647.0;

// Out of line, or every row would contain a copy of both.
[[gnu::noinline]] inline std::uint32_t bitsOf(double x) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(x));
}
[[gnu::noinline]] inline double intOf(std::uint32_t bits) {
  return static_cast<std::int32_t>(bits);
}

inline double wrapToInt(double x) { return intOf(bitsOf(x)); }
inline double intSum(double x, double y) { return wrapToInt(x + y); }
inline double intDifference(double x, double y) { return wrapToInt(x - y); }
inline double intProduct(double x, double y) { return intOf(bitsOf(x) * bitsOf(y)); }

// Rounds toward zero. Division by zero returns the dividend, as in WGSL.
inline double intQuotient(double x, double y) { return y == 0 ? x : wrapToInt(std::trunc(x / y)); }
inline double intRemainder(double x, double y) {
  return intDifference(x, intProduct(intQuotient(x, y), y == 0 ? 1 : y));
}
inline double bitsQuotient(double x, double y) { return y == 0 ? x : intOf(bitsOf(x) / bitsOf(y)); }
inline double bitsRemainder(double x, double y) {
  return y == 0 ? 0 : intOf(bitsOf(x) % bitsOf(y));
}

inline double bitAnd(double x, double y) { return intOf(bitsOf(x) & bitsOf(y)); }
inline double bitOr(double x, double y) { return intOf(bitsOf(x) | bitsOf(y)); }
inline double bitXor(double x, double y) { return intOf(bitsOf(x) ^ bitsOf(y)); }
inline double bitNot(double x) { return intOf(~bitsOf(x)); }
inline double shiftLeft(double x, double y) { return intOf(bitsOf(x) << (bitsOf(y) & 31)); }
inline double shiftRight(double x, double y) {
  return static_cast<std::int32_t>(bitsOf(x)) >> (bitsOf(y) & 31);
}
inline double bitsShiftRight(double x, double y) { return intOf(bitsOf(x) >> (bitsOf(y) & 31)); }

// Converts a float to an integer; floats out of range to the nearest one, as in WGSL.
inline double truncate(double x) {
  if (x != x) return 0;
  return std::trunc(std::fmin(std::fmax(x, minInt), maxInt));
}
inline double truncateBits(double x) {
  if (x != x) return 0;
  return intOf(bitsOf(std::trunc(std::fmin(std::fmax(x, 0.0), 4294967295.0))));
}
inline double asFloat(double x) { return static_cast<float>(x); }
inline double bitsAsFloat(double x) { return static_cast<float>(bitsOf(x)); }

inline double floatBits(double x) {
  return intOf(__builtin_bit_cast(std::uint32_t, static_cast<float>(x)));
}
inline double floatOfBits(double x) { return __builtin_bit_cast(float, bitsOf(x)); }

// The following functions return the ranges of those operations for which a range is useful.
// Results that may wrap around have the full range.
inline Interval anyInt() { return {minInt, maxInt}; }
Interval intSum(const Interval& x, const Interval& y);
Interval intRemainder(const Interval& x, const Interval& y);
Interval bitAnd(const Interval& x, const Interval& y);
Interval bitsShiftRight(const Interval& x, const Interval& y);
Interval truncate(const Interval& x);
Interval asFloat(const Interval& x);
Interval bitsAsFloat(const Interval& x);

}  // namespace warpjet::ops
