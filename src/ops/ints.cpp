// Ranges of integers.
#include "ops/ints.hpp"

#include <algorithm>

namespace warpjet::ops {

namespace {

constexpr double bitCount = 4294967296.0;

// Returns a range; if it exceeds that of an int, so that the result wraps around, any integer.
Interval anyIfWrapped(double low, double high) {
  return minInt <= low && high <= maxInt ? Interval(low, high) : anyInt();
}

}  // namespace

Interval intSum(const Interval& x, const Interval& y) {
  return anyIfWrapped(x.low + y.low, x.high + y.high);
}

// Bounds a remainder, which is smaller than the divisor and has the sign of the dividend.
Interval intRemainder(const Interval& x, const Interval& y) {
  const double largest = std::max({-y.low, y.high, 1.0}) - 1;
  return {x.low < 0 ? std::max(x.low, -largest) : 0.0,
          x.high > 0 ? std::min(x.high, largest) : 0.0};
}

Interval bitAnd(const Interval& x, const Interval& y) {
  const double mask = std::max(x.low < 0 ? -1 : x.high, y.low < 0 ? -1 : y.high);
  if (mask < 0) return anyInt();
  return {0, x.low < 0 ? y.high : y.low < 0 ? x.high : std::min(x.high, y.high)};
}

Interval bitsShiftRight(const Interval& x, const Interval& y) {
  if (!y.isPoint()) return x.low < 0 ? anyInt() : Interval(0, x.high);
  if (x.low >= 0) return {bitsShiftRight(x.low, y.low), bitsShiftRight(x.high, y.low)};
  return bitsOf(y.low) % 32 == 0 ? anyInt() : Interval(0, bitsShiftRight(-1.0, y.low));
}

Interval truncate(const Interval& x) {
  if (x.isEmpty()) return 0;
  return {std::min(truncate(x.low), x.canBeNaN ? 0.0 : maxInt),
          std::max(truncate(x.high), x.canBeNaN ? 0.0 : minInt)};
}

Interval asFloat(const Interval& x) { return {asFloat(x.low), asFloat(x.high)}; }

Interval bitsAsFloat(const Interval& x) { return x.low < 0 ? Interval(0, bitCount) : asFloat(x); }

}  // namespace warpjet::ops
