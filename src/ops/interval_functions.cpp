// Powers, exponentials, angles and hyperbolic functions of intervals.
#include "ops/interval_parts.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

using namespace intervals;

namespace {

// Whether some start + k * period lies in x or a share of its numbers beside it, for a whole k.
bool hits(const Interval& x, double start, double period, double share) {
  const double from = (x.low - start) / period, to = (x.high - start) / period;
  const double slack = (std::abs(from) + std::abs(to) + 1) * share;
  return std::ceil(from - slack) <= std::floor(to + slack);
}

// sin or cos, by where it is 1.
Interval wave(Unary f, const Interval& x, double peak) {
  if (x.isEmpty()) return x;
  if (x.canBeInfinite()) return {-1, 1, true};
  if (x.high - x.low >= 2 * pi) return {-1, 1, x.canBeNaN};
  const double first = f(x.low), last = f(x.high);
  Interval y = widened(std::min(first, last), std::max(first, last), function, x.canBeNaN);
  if (hits(x, peak, 2 * pi, 0x1p-50)) y.high = 1;
  if (hits(x, peak + pi, 2 * pi, 0x1p-50)) y.low = -1;
  return withZeros(limited(y, -1, 1));
}

bool isWhole(double x) { return x == std::floor(x); }

// x to the power of y for x that is not negative: y log(x) is bilinear, so extremes are at corners.
Interval powerOfPositive(const Interval& x, const Interval& y) {
  return corners(std::pow, x, y, 2 * function);
}

}  // namespace

Interval pow(const Interval& x, const Interval& y) {
  const bool isOne = (x.canBeNaN && y.has(0)) || (y.canBeNaN && x.has(1));
  Interval result = nothing();
  if (!x.isEmpty() && !y.isEmpty()) {
    if (x.high >= 0) result = powerOfPositive(limited(x, 0, infinity), y);
    if (isNegative(x.low)) {
      // Of a number below zero only whole exponents have a power, which may have either sign.
      const bool isWholePoint = y.isPoint() && isWhole(y.low);
      if (std::floor(y.high) >= y.low) {
        const Interval size = powerOfPositive(limited(-x, 0, infinity), y);
        const bool isOdd = isWholePoint && y.low != 2 * std::floor(y.low / 2);
        if (!isOdd) result = result.isEmpty() ? size : join(result, size);
        if (isOdd || !isWholePoint) result = result.isEmpty() ? -size : join(result, -size);
      }
      result.canBeNaN |= !isWholePoint && x.low < 0;
    }
    result.canBeNaN |= x.canBeNaN || y.canBeNaN;
  }
  return isOne ? join(result, 1.0) : result;
}

Interval sqrt(const Interval& x) {
  const Interval part = within(x, -0.0, infinity);
  if (part.isEmpty()) return nothing();
  return widened(std::sqrt(part.low), std::sqrt(part.high), rounding, part.canBeNaN);
}

Interval inversesqrt(const Interval& x) { return 1.0 / sqrt(x); }

Interval exp(const Interval& x) { return rising(std::exp, x); }

Interval exp2(const Interval& x) { return rising(ops::exp2, x); }

Interval log(const Interval& x) { return rising(std::log, within(x, 0, infinity)); }

Interval log2(const Interval& x) { return rising(ops::log2, within(x, 0, infinity)); }

Interval sin(const Interval& x) { return wave(std::sin, x, pi / 2); }

Interval cos(const Interval& x) { return wave(std::cos, x, 0); }

Interval tan(const Interval& x) {
  if (x.isEmpty()) return x;
  if (x.canBeInfinite()) return Interval::anything(true);
  if (x.high - x.low >= pi || hits(x, pi / 2, pi, rounding)) return Interval::anything(x.canBeNaN);
  return rising(std::tan, x);
}

Interval asin(const Interval& x) { return rising(std::asin, within(x, -1, 1)); }

Interval acos(const Interval& x) {
  return -rising([](double y) { return -std::acos(y); }, within(x, -1, 1));
}

Interval atan(const Interval& x) { return rising(std::atan, x); }

Interval atan2(const Interval& y, const Interval& x) {
  if (x.isEmpty() || y.isEmpty()) return nothing();
  // Both sides of the negative half of the axis, where the angle jumps; or a zero of either sign.
  const bool crosses = isNegative(y.low) && !isNegative(y.high);
  const bool isCut = isNegative(x.low) && (crosses || (y.low == 0 && y.high == 0));
  if (isCut) return widened(-pi, pi, function, x.canBeNaN || y.canBeNaN);
  return corners(std::atan2, y, x, function);
}

Interval sinh(const Interval& x) { return rising(std::sinh, x); }

Interval cosh(const Interval& x) { return rising(std::cosh, abs(x)); }

Interval tanh(const Interval& x) { return limited(rising(std::tanh, x), -1, 1); }

Interval asinh(const Interval& x) { return rising(std::asinh, x); }

Interval acosh(const Interval& x) { return rising(std::acosh, within(x, 1, infinity)); }

Interval atanh(const Interval& x) { return rising(std::atanh, within(x, -1, 1)); }

}  // namespace warpjet
