// Powers, exponentials, angles and hyperbolic functions of intervals.
#include "ops/interval_parts.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

using namespace intervals;

namespace {

// Returns true if start + k * period is in x, or within a relative distance of `relativeError`, for
// some integer k.
bool containsMultiple(const Interval& x, double start, double period, double relativeError) {
  const double from = (x.low - start) / period, to = (x.high - start) / period;
  const double slack = (std::abs(from) + std::abs(to) + 1) * relativeError;
  return std::ceil(from - slack) <= std::floor(to + slack);
}

// Returns the range of f, sin or cos, whose value at `peak` is 1.
Interval wave(Unary f, const Interval& x, double peak) {
  if (x.isEmpty()) return x;
  if (x.canBeInfinite()) return {-1, 1, true};
  if (x.high - x.low >= 2 * pi) return {-1, 1, x.canBeNaN};
  const double first = f(x.low), last = f(x.high);
  Interval y = widen(std::min(first, last), std::max(first, last), functionError, x.canBeNaN);
  if (containsMultiple(x, peak, 2 * pi, 0x1p-50)) y.high = 1;
  if (containsMultiple(x, peak + pi, 2 * pi, 0x1p-50)) y.low = -1;
  return withZeros(clipTo(y, -1, 1));
}

bool isInteger(double x) { return x == std::floor(x); }

// Returns x to the power of y for nonnegative x. y log(x) is bilinear, so the extremes are at the
// corners.
Interval powerOfPositive(const Interval& x, const Interval& y) {
  return hullOfCorners(std::pow, x, y, 2 * functionError);
}

}  // namespace

Interval pow(const Interval& x, const Interval& y) {
  const bool canBeOne = (x.canBeNaN && y.has(0)) || (y.canBeNaN && x.has(1));
  Interval result = emptyInterval();
  if (!x.isEmpty() && !y.isEmpty()) {
    if (x.high >= 0) result = powerOfPositive(clipTo(x, 0, infinity), y);
    if (isNegative(x.low)) {
      // A negative base only has powers for integer exponents, and those may have either sign.
      const bool isIntegerPoint = y.isPoint() && isInteger(y.low);
      if (std::floor(y.high) >= y.low) {
        const Interval size = powerOfPositive(clipTo(-x, 0, infinity), y);
        const bool isOdd = isIntegerPoint && y.low != 2 * std::floor(y.low / 2);
        if (!isOdd) result = result.isEmpty() ? size : join(result, size);
        if (isOdd || !isIntegerPoint) result = result.isEmpty() ? -size : join(result, -size);
      }
      result.canBeNaN |= !isIntegerPoint && x.low < 0;
    }
    result.canBeNaN |= x.canBeNaN || y.canBeNaN;
  }
  return canBeOne ? join(result, 1.0) : result;
}

Interval sqrt(const Interval& x) {
  const Interval part = clipToDomain(x, -0.0, infinity);
  if (part.isEmpty()) return emptyInterval();
  return widen(std::sqrt(part.low), std::sqrt(part.high), rounding, part.canBeNaN);
}

Interval inversesqrt(const Interval& x) { return 1.0 / sqrt(x); }

Interval exp(const Interval& x) { return increasing(std::exp, x); }

Interval exp2(const Interval& x) { return increasing(ops::exp2, x); }

Interval log(const Interval& x) { return increasing(std::log, clipToDomain(x, 0, infinity)); }

Interval log2(const Interval& x) { return increasing(ops::log2, clipToDomain(x, 0, infinity)); }

Interval sin(const Interval& x) { return wave(std::sin, x, pi / 2); }

Interval cos(const Interval& x) { return wave(std::cos, x, 0); }

Interval tan(const Interval& x) {
  if (x.isEmpty()) return x;
  if (x.canBeInfinite()) return Interval::anything(true);
  if (x.high - x.low >= pi || containsMultiple(x, pi / 2, pi, rounding))
    return Interval::anything(x.canBeNaN);
  return increasing(std::tan, x);
}

Interval asin(const Interval& x) { return increasing(std::asin, clipToDomain(x, -1, 1)); }

Interval acos(const Interval& x) {
  return -increasing([](double y) { return -std::acos(y); }, clipToDomain(x, -1, 1));
}

Interval atan(const Interval& x) { return increasing(std::atan, x); }

Interval atan2(const Interval& y, const Interval& x) {
  if (x.isEmpty() || y.isEmpty()) return emptyInterval();
  // True if the range includes both sides of the cut, where the angle jumps, or zeros of either
  // sign.
  const bool crosses = isNegative(y.low) && !isNegative(y.high);
  const bool isCut = isNegative(x.low) && (crosses || (y.low == 0 && y.high == 0));
  if (isCut) return widen(-pi, pi, functionError, x.canBeNaN || y.canBeNaN);
  return hullOfCorners(std::atan2, y, x, functionError);
}

Interval sinh(const Interval& x) { return increasing(std::sinh, x); }

Interval cosh(const Interval& x) { return increasing(std::cosh, abs(x)); }

Interval tanh(const Interval& x) { return clipTo(increasing(std::tanh, x), -1, 1); }

Interval asinh(const Interval& x) { return increasing(std::asinh, x); }

Interval acosh(const Interval& x) { return increasing(std::acosh, clipToDomain(x, 1, infinity)); }

Interval atanh(const Interval& x) { return increasing(std::atanh, clipToDomain(x, -1, 1)); }

}  // namespace warpjet
