// Piecewise functions of intervals: steps, bounds, blends and conditions.
#include "ops/interval_parts.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

using namespace intervals;

namespace {

// Joins the result with the operands: an operation may return one operand if the other is NaN.
Interval joinOtherIfNaN(Interval result, const Interval& x, const Interval& y) {
  if (x.canBeNaN) result = join(result, y);
  if (y.canBeNaN) result = join(result, x);
  return result;
}

// Returns x - y f, where f = floor(x / y): from 0 to y, and no wider than x if f is constant.
Interval modulo(const Interval& x, const Interval& y) {
  const Interval quotient = x / y;
  if (quotient.canBeInfinite()) return Interval::anything(true);
  const double ints = std::floor(quotient.low);
  double low = std::min(y.low, 0.0), high = std::max(y.high, 0.0);
  if (ints == std::floor(quotient.high)) {
    const Interval rest = x - y * ints;
    low = std::clamp(rest.low, low, high);
    high = std::clamp(rest.high, low, high);
  }
  // The product is rounded relative to its own size, so the result may exceed the divisor's range.
  const double error = (std::max(-x.low, x.high) + std::max(-y.low, y.high)) * 2 * rounding;
  return withZeros({low - error, high + error, x.canBeNaN || y.canBeNaN});
}

}  // namespace

Interval abs(const Interval& x) {
  if (x.isEmpty()) return x;
  return {std::abs(std::max({x.low, -x.high, 0.0})), std::max(-x.low, x.high), x.canBeNaN};
}

Interval sign(const Interval& x) {
  const auto f = [](double y) { return static_cast<double>((y > 0) - (y < 0)); };
  const Interval result = increasing(f, x, 0);
  return x.canBeNaN ? join(result, {-0.0, 0.0, true}) : result;
}

Interval floor(const Interval& x) { return increasing(std::floor, x, 0); }

Interval ceil(const Interval& x) { return increasing(std::ceil, x, 0); }

Interval round(const Interval& x) { return increasing(std::nearbyint, x, 0); }

Interval trunc(const Interval& x) { return increasing(std::trunc, x, 0); }

Interval hash(const Interval& h, const Interval& i) {
  const Interval from = floor(h), cell = floor(i);
  // Beyond that, float32 can't represent a cell and a position within it.
  for (const Interval& x : {from, cell}) {
    if (x.low < -0x1p24 || x.high > 0x1p24) return Interval::anything(true);
  }
  if (from.isPoint() && cell.isPoint() && !from.canBeNaN && !cell.canBeNaN)
    return ops::hash(from.low, cell.low);
  return {0, ops::hashPrime - 1, from.canBeNaN || cell.canBeNaN};
}

Interval fract(const Interval& x) {
  if (x.isEmpty()) return x;
  const double ints = std::floor(x.low);
  const bool jumps = ints != std::floor(x.high);
  if (jumps || x.canBeInfinite()) return {-0.0, 1, x.canBeNaN || x.canBeInfinite()};
  return withZeros(clipTo(x - ints, 0, 1));
}

Interval mod(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return emptyInterval();
  if (y.has(0) || x.canBeInfinite() || y.canBeInfinite()) return Interval::anything(true);
  return modulo(x, y);
}

Interval min(const Interval& x, const Interval& y) {
  const bool canBeNaN = x.canBeNaN || y.canBeNaN;
  if (x.isEmpty() || y.isEmpty()) return joinOtherIfNaN(emptyInterval(), x, y);
  return joinOtherIfNaN(withZeros({std::min(x.low, y.low), std::min(x.high, y.high), canBeNaN}), x,
                        y);
}

Interval max(const Interval& x, const Interval& y) { return -min(-x, -y); }

// A blend is linear in each operand, so its extremes are at the ends of the amount's range.
Interval mix(const Interval& x, const Interval& y, const Interval& amount) {
  if (amount.isEmpty()) return amount;
  const auto at = [&](double t) { return x * (1.0 - Interval(t)) + y * t; };
  Interval result = amount.isPoint() ? at(amount.low) : join(at(amount.low), at(amount.high));
  result.canBeNaN |= amount.canBeNaN;
  return result;
}

Interval step(const Interval& edge, const Interval& x) { return ifElse(lt(x, edge), 0.0, 1.0); }

// Comparisons with NaN may give either result, since compilers may invert them.
Truth lt(const Interval& x, const Interval& y) {
  if (x.canBeNaN || y.canBeNaN) return {true, true};
  return {x.low < y.high, x.high >= y.low};
}

Truth le(const Interval& x, const Interval& y) { return logicalNot(lt(y, x)); }

Truth eq(const Interval& x, const Interval& y) {
  if (x.canBeNaN || y.canBeNaN) return {true, true};
  return {x.low <= y.high && y.low <= x.high, !(x.isPoint() && y.isPoint() && x.low == y.low)};
}

Interval ifElse(Truth condition, const Interval& yes, const Interval& no) {
  if (!condition.canBeFalse) return yes;
  if (!condition.canBeTrue) return no;
  return join(yes, no);
}

}  // namespace warpjet
