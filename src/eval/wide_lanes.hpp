// Four doubles, for functions that would lose precision in float. They are in two registers, to
// each of which operations are applied.
#pragma once

#include "eval/lanes.hpp"

namespace warpjet {

struct WideMask {
  simd::DoubleBits low, high;
};

struct WideLanes {
  simd::Doubles low, high;

  WideLanes() = default;
  WideLanes(simd::Doubles first, simd::Doubles last) : low(first), high(last) {}
  WideLanes(double x) : low{x, x}, high{x, x} {}
  explicit WideLanes(Lanes x) : low(simd::widenLow(x.floats)), high(simd::widenHigh(x.floats)) {}
};

// Rounds to the nearest floats.
inline Lanes narrow(WideLanes x) { return simd::narrow(x.low, x.high); }

inline WideMask asMask(WideLanes x) { return {simd::bitsOf(x.low), simd::bitsOf(x.high)}; }
inline WideLanes asLanes(WideMask x) { return {simd::doublesOf(x.low), simd::doublesOf(x.high)}; }

inline WideLanes operator+(WideLanes x, WideLanes y) { return {x.low + y.low, x.high + y.high}; }
inline WideLanes operator-(WideLanes x, WideLanes y) { return {x.low - y.low, x.high - y.high}; }
inline WideLanes operator*(WideLanes x, WideLanes y) { return {x.low * y.low, x.high * y.high}; }
inline WideLanes operator/(WideLanes x, WideLanes y) { return {x.low / y.low, x.high / y.high}; }
inline WideLanes operator-(WideLanes x) { return {-x.low, -x.high}; }
inline WideLanes sqrt(WideLanes x) { return {simd::sqrt(x.low), simd::sqrt(x.high)}; }

inline WideMask operator&(WideMask x, WideMask y) { return {x.low & y.low, x.high & y.high}; }
inline WideMask operator|(WideMask x, WideMask y) { return {x.low | y.low, x.high | y.high}; }
// Adds unsigned integers, which may wrap.
inline WideMask operator+(WideMask x, WideMask y) {
  using Unsigned = std::uint64_t __attribute__((vector_size(16)));
  const auto sum = [](simd::DoubleBits a, simd::DoubleBits b) {
    return __builtin_bit_cast(simd::DoubleBits,
                              __builtin_bit_cast(Unsigned, a) + __builtin_bit_cast(Unsigned, b));
  };
  return {sum(x.low, y.low), sum(x.high, y.high)};
}
inline WideMask operator-(WideMask x) { return {-x.low, -x.high}; }
// Repeats an integer four times.
inline WideMask wideMask(std::int64_t x) {
  const simd::DoubleBits two = {x, x};
  return {two, two};
}

inline WideMask lt(WideLanes x, WideLanes y) { return {x.low < y.low, x.high < y.high}; }
inline WideMask gt(WideLanes x, WideLanes y) { return {x.low > y.low, x.high > y.high}; }
inline WideMask ge(WideLanes x, WideLanes y) { return {x.low >= y.low, x.high >= y.high}; }
inline WideMask eq(WideLanes x, WideLanes y) { return {x.low == y.low, x.high == y.high}; }

inline WideLanes ifElse(WideMask condition, WideLanes yes, WideLanes no) {
  return {simd::select(condition.low, yes.low, no.low),
          simd::select(condition.high, yes.high, no.high)};
}

}  // namespace warpjet
