#include "ops/interval.hpp"

#include "ops/interval_parts.hpp"

namespace warpjet {

using namespace intervals;

namespace {

// Returns x y; 0 times infinity is 0, the limit at the corners of a box.
double product(double x, double y) { return x == 0 || y == 0 ? 0 : x * y; }

// Returns the hull of the values of a product or quotient at the corners of a box.
Interval hullOfScaledCorners(Binary f, const Interval& x, const Interval& y, double relativeError) {
  Interval result = hullOfCorners(f, x, y, relativeError);
  // Keeps the zero positive for nonnegative factors, as in a product of lengths.
  if (result.low == 0 && !isNegative(x.low) && !isNegative(y.low)) result.low = 0.0;
  return result;
}

}  // namespace

Interval increasing(Unary f, const Interval& x, double relativeError) {
  if (x.isEmpty()) return x;
  const double low = f(x.low), high = f(x.high);
  if (std::isnan(low) || std::isnan(high)) return Interval::anything(true);
  return withZeros(widen(low, high, relativeError, x.canBeNaN));
}

Interval withFloat32(const Interval& x) {
  using Limits = std::numeric_limits<float>;
  constexpr double max = Limits::max(), minNormal = Limits::min();
  Interval result = x;
  if (x.low < -max) result.low = -infinity;
  if (x.high > max) result.high = infinity;
  if (x.low > 0 && x.low < minNormal) result.low = 0.0;
  if (x.high < 0 && x.high > -minNormal) result.high = -0.0;
  return result;
}

Interval join(const Interval& x, const Interval& y) {
  const bool canBeNaN = x.canBeNaN || y.canBeNaN;
  if (x.isEmpty()) return {y.low, y.high, canBeNaN};
  if (y.isEmpty()) return {x.low, x.high, canBeNaN};
  const bool lowIsNegative = isNegative(x.low) || isNegative(y.low);
  const bool highIsNegative = isNegative(x.high) && isNegative(y.high);
  const double low = std::min(x.low, y.low), high = std::max(x.high, y.high);
  return {low == 0 && lowIsNegative ? -0.0 : low, high == 0 && !highIsNegative ? 0.0 : high,
          canBeNaN};
}

Interval clipTo(const Interval& x, double low, double high) {
  return {std::max(x.low, low), std::min(x.high, high), x.canBeNaN};
}

Interval operator-(const Interval& x) { return {-x.high, -x.low, x.canBeNaN}; }

Interval operator+(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return emptyInterval();
  const bool canCancel =
      (x.high == infinity && y.low == -infinity) || (x.low == -infinity && y.high == infinity);
  if (canCancel) return Interval::anything(true);
  return widen(x.low + y.low, x.high + y.high, rounding, x.canBeNaN || y.canBeNaN);
}

Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

Interval operator*(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return emptyInterval();
  Interval result = hullOfScaledCorners(product, x, y, rounding);
  result.canBeNaN |= (x.has(0) && y.canBeInfinite()) || (y.has(0) && x.canBeInfinite());
  return result;
}

Interval square(const Interval& x) {
  if (x.isEmpty()) return x;
  const double low = std::max({x.low, -x.high, 0.0}), high = std::max(-x.low, x.high);
  return widen(low * low, high * high, rounding, x.canBeNaN);
}

Interval operator/(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return emptyInterval();
  const bool canBeNaN = x.canBeNaN || y.canBeNaN || (x.has(0) && y.has(0)) ||
                        (x.canBeInfinite() && y.canBeInfinite());
  const bool hasBothSigns = isNegative(y.low) != isNegative(y.high);
  if (hasBothSigns || (y.low == 0 && y.high == 0)) return Interval::anything(canBeNaN);
  // Takes the limits at the corners; where there is none, the other corners bound the values around
  // it.
  const auto quotient = [](double a, double b) {
    return a == 0 || std::abs(b) == infinity ? 0 : a / b;
  };
  Interval result = hullOfScaledCorners(quotient, x, y, divisionError);
  result.canBeNaN = canBeNaN;
  return result;
}

}  // namespace warpjet
