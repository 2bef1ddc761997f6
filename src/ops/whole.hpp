// Whole numbers of 32 bits, for the rows of the table: from -2^31 up, whether a text counts them
// with a sign or without, since sums, products and bits are the same. What differs has two rows.
// As doubles they are exact; results wrap around.
#pragma once

#include <cmath>
#include <cstdint>

#include "ops/interval.hpp"

namespace warpjet::ops {

inline constexpr double leastWhole = -2147483648.0, mostWhole = 2147483647.0;

// One copy of each, or every row would be as long as both.
[[gnu::noinline]] inline std::uint32_t bitsOf(double x) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(x));
}
[[gnu::noinline]] inline double wholeOf(std::uint32_t bits) {
  return static_cast<std::int32_t>(bits);
}

inline double whole(double x) { return wholeOf(bitsOf(x)); }
inline double wholeSum(double x, double y) { return whole(x + y); }
inline double wholeDifference(double x, double y) { return whole(x - y); }
inline double wholeProduct(double x, double y) { return wholeOf(bitsOf(x) * bitsOf(y)); }

// Towards zero. By zero as in WGSL, where it gives what was divided.
inline double wholeQuotient(double x, double y) { return y == 0 ? x : whole(std::trunc(x / y)); }
inline double wholeRemainder(double x, double y) {
  return wholeDifference(x, wholeProduct(wholeQuotient(x, y), y == 0 ? 1 : y));
}
inline double bitsQuotient(double x, double y) {
  return y == 0 ? x : wholeOf(bitsOf(x) / bitsOf(y));
}
inline double bitsRemainder(double x, double y) {
  return y == 0 ? 0 : wholeOf(bitsOf(x) % bitsOf(y));
}

inline double bitAnd(double x, double y) { return wholeOf(bitsOf(x) & bitsOf(y)); }
inline double bitOr(double x, double y) { return wholeOf(bitsOf(x) | bitsOf(y)); }
inline double bitXor(double x, double y) { return wholeOf(bitsOf(x) ^ bitsOf(y)); }
inline double bitNot(double x) { return wholeOf(~bitsOf(x)); }
inline double shiftLeft(double x, double y) { return wholeOf(bitsOf(x) << (bitsOf(y) & 31)); }
inline double shiftRight(double x, double y) {
  return static_cast<std::int32_t>(bitsOf(x)) >> (bitsOf(y) & 31);
}
inline double bitsShiftRight(double x, double y) { return wholeOf(bitsOf(x) >> (bitsOf(y) & 31)); }

// A float that is too large gives the end that it is nearest to, as in WGSL.
inline double truncated(double x) {
  if (x != x) return 0;
  return std::trunc(std::fmin(std::fmax(x, leastWhole), mostWhole));
}
inline double truncatedBits(double x) {
  if (x != x) return 0;
  return wholeOf(bitsOf(std::trunc(std::fmin(std::fmax(x, 0.0), 4294967295.0))));
}
inline double asFloat(double x) { return static_cast<float>(x); }
inline double bitsAsFloat(double x) { return static_cast<float>(bitsOf(x)); }

inline double floatBits(double x) {
  return wholeOf(__builtin_bit_cast(std::uint32_t, static_cast<float>(x)));
}
inline double floatOfBits(double x) { return __builtin_bit_cast(float, bitsOf(x)); }

// What they can be, where that is of use. What may wrap around may be anything.
inline Interval anyWhole() { return {leastWhole, mostWhole}; }
Interval wholeSum(const Interval& x, const Interval& y);
Interval wholeRemainder(const Interval& x, const Interval& y);
Interval bitAnd(const Interval& x, const Interval& y);
Interval bitsShiftRight(const Interval& x, const Interval& y);
Interval truncated(const Interval& x);
Interval asFloat(const Interval& x);
Interval bitsAsFloat(const Interval& x);

}  // namespace warpjet::ops
