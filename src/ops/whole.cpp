// What whole numbers can be.
#include "ops/whole.hpp"

#include <algorithm>

namespace warpjet::ops {

namespace {

constexpr double bitCount = 4294967296.0;

// Those of a sum or product that may wrap around can be anything.
Interval unlessWrapped(double low, double high) {
  return leastWhole <= low && high <= mostWhole ? Interval(low, high) : anyWhole();
}

}  // namespace

Interval wholeSum(const Interval& x, const Interval& y) {
  return unlessWrapped(x.low + y.low, x.high + y.high);
}

// Smaller than the divisor, and of the sign of what is divided.
Interval wholeRemainder(const Interval& x, const Interval& y) {
  const double largest = std::max({-y.low, y.high, 1.0}) - 1;
  return {x.low < 0 ? std::max(x.low, -largest) : 0.0,
          x.high > 0 ? std::min(x.high, largest) : 0.0};
}

Interval bitAnd(const Interval& x, const Interval& y) {
  const double mask = std::max(x.low < 0 ? -1 : x.high, y.low < 0 ? -1 : y.high);
  if (mask < 0) return anyWhole();
  return {0, x.low < 0 ? y.high : y.low < 0 ? x.high : std::min(x.high, y.high)};
}

Interval bitsShiftRight(const Interval& x, const Interval& y) {
  if (!y.isPoint()) return x.low < 0 ? anyWhole() : Interval(0, x.high);
  if (x.low >= 0) return {bitsShiftRight(x.low, y.low), bitsShiftRight(x.high, y.low)};
  return bitsOf(y.low) % 32 == 0 ? anyWhole() : Interval(0, bitsShiftRight(-1.0, y.low));
}

Interval truncated(const Interval& x) {
  if (x.isEmpty()) return 0;
  return {std::min(truncated(x.low), x.canBeNaN ? 0.0 : mostWhole),
          std::max(truncated(x.high), x.canBeNaN ? 0.0 : leastWhole)};
}

Interval asFloat(const Interval& x) { return {asFloat(x.low), asFloat(x.high)}; }

Interval bitsAsFloat(const Interval& x) { return x.low < 0 ? Interval(0, bitCount) : asFloat(x); }

}  // namespace warpjet::ops
