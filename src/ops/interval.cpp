#include "ops/interval.hpp"

#include <algorithm>
#include <cmath>

#include "ops/scalar.hpp"

namespace warpjet {

namespace {

constexpr double infinity = Interval::infinity;
constexpr double pi = 3.14159265358979323846;

// A share of the value, to widen by: what shaders may err by in a division and in a function (GLSL
// ES 3.00 leaves it open; WGSL, section 15.7.4, has 2.5 ulp for a division and 3 to 4 ulp for most
// functions near 1).
constexpr double division = 4 * rounding, function = 8 * rounding;

double below(double low, double share) { return low * (low < 0 ? 1 + share : 1 - share); }
double above(double high, double share) { return high * (high < 0 ? 1 - share : 1 + share); }

Interval widened(double low, double high, double share, bool canBeNaN) {
  return withFloat32({below(low, share), above(high, share), canBeNaN});
}

// With zeros that may have either sign.
Interval withZeros(const Interval& x) {
  return {x.low == 0 ? -0.0 : x.low, x.high == 0 ? 0.0 : x.high, x.canBeNaN};
}

Interval nothing() { return {}; }

// What is left between two numbers; whatever is cut off is no number.
Interval within(const Interval& x, double low, double high) {
  const bool cut = x.low < low || x.high > high;
  return {std::max(x.low, low), std::min(x.high, high), x.canBeNaN || cut};
}

using Unary = double(double);
using Binary = double(double, double);

// 0 times infinity counts as 0, its limit at the corners of a box.
double product(double x, double y) { return x == 0 || y == 0 ? 0 : x * y; }

bool isNegative(double x) { return std::signbit(x); }

// The hull of f at the corners of a box.
Interval corners(Binary f, const Interval& x, const Interval& y, double share) {
  const double a = f(x.low, y.low), b = f(x.low, y.high);
  const double c = f(x.high, y.low), d = f(x.high, y.high);
  const double low = std::min(std::min(a, b), std::min(c, d));
  const double high = std::max(std::max(a, b), std::max(c, d));
  return withZeros(widened(low, high, share, x.canBeNaN || y.canBeNaN));
}

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

// Of operations whose result may be the other operand where one is no number.
Interval orOther(Interval result, const Interval& x, const Interval& y) {
  if (x.canBeNaN) result = join(result, y);
  if (y.canBeNaN) result = join(result, x);
  return result;
}

bool isWhole(double x) { return x == std::floor(x); }

// x to the power of y for x that is not negative: y log(x) is bilinear, so extremes are at corners.
Interval powerOfPositive(const Interval& x, const Interval& y) {
  return corners(std::pow, x, y, 2 * function);
}

// By f = floor(x / y), the result is x - y f: from 0 to y, and where f is the same everywhere, as
// wide as x.
Interval modulo(const Interval& x, const Interval& y) {
  const Interval quotient = x / y;
  if (quotient.canBeInfinite()) return Interval::anything(true);
  const double wholes = std::floor(quotient.low);
  double low = std::min(y.low, 0.0), high = std::max(y.high, 0.0);
  if (wholes == std::floor(quotient.high)) {
    const Interval rest = x - y * wholes;
    low = std::clamp(rest.low, low, high);
    high = std::clamp(rest.high, low, high);
  }
  // The product is rounded by its own size, so that the result may leave the divisor's range.
  const double error = (std::max(-x.low, x.high) + std::max(-y.low, y.high)) * 2 * rounding;
  return withZeros({low - error, high + error, x.canBeNaN || y.canBeNaN});
}

// What a product or a quotient has in common.
Interval multiplied(Binary f, const Interval& x, const Interval& y, double share) {
  Interval result = corners(f, x, y, share);
  // Keeps what is not negative so: a product of lengths.
  if (result.low == 0 && !isNegative(x.low) && !isNegative(y.low)) result.low = 0.0;
  return result;
}

}  // namespace

Interval rising(Unary f, const Interval& x, double share) {
  if (x.isEmpty()) return x;
  const double low = f(x.low), high = f(x.high);
  if (std::isnan(low) || std::isnan(high)) return Interval::anything(true);
  return withZeros(widened(low, high, share, x.canBeNaN));
}

Interval withFloat32(const Interval& x) {
  using Limits = std::numeric_limits<float>;
  constexpr double most = Limits::max(), least = Limits::min();
  Interval result = x;
  if (x.low < -most) result.low = -infinity;
  if (x.high > most) result.high = infinity;
  if (x.low > 0 && x.low < least) result.low = 0.0;
  if (x.high < 0 && x.high > -least) result.high = -0.0;
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

Interval limited(const Interval& x, double low, double high) {
  return {std::max(x.low, low), std::min(x.high, high), x.canBeNaN};
}

Interval operator-(const Interval& x) { return {-x.high, -x.low, x.canBeNaN}; }

Interval operator+(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return nothing();
  const bool canCancel =
      (x.high == infinity && y.low == -infinity) || (x.low == -infinity && y.high == infinity);
  if (canCancel) return Interval::anything(true);
  return widened(x.low + y.low, x.high + y.high, rounding, x.canBeNaN || y.canBeNaN);
}

Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

Interval operator*(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return nothing();
  Interval result = multiplied(product, x, y, rounding);
  result.canBeNaN |= (x.has(0) && y.canBeInfinite()) || (y.has(0) && x.canBeInfinite());
  return result;
}

Interval square(const Interval& x) {
  if (x.isEmpty()) return x;
  const double low = std::max({x.low, -x.high, 0.0}), high = std::max(-x.low, x.high);
  return widened(low * low, high * high, rounding, x.canBeNaN);
}

Interval operator/(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return nothing();
  const bool canBeNaN = x.canBeNaN || y.canBeNaN || (x.has(0) && y.has(0)) ||
                        (x.canBeInfinite() && y.canBeInfinite());
  const bool hasBothSigns = isNegative(y.low) != isNegative(y.high);
  if (hasBothSigns || (y.low == 0 && y.high == 0)) return Interval::anything(canBeNaN);
  // The limits at the corners; where there is none, the other corners hold what lies around.
  const auto quotient = [](double a, double b) {
    return a == 0 || std::abs(b) == infinity ? 0 : a / b;
  };
  Interval result = multiplied(quotient, x, y, division);
  result.canBeNaN = canBeNaN;
  return result;
}

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

Interval abs(const Interval& x) {
  if (x.isEmpty()) return x;
  return {std::abs(std::max({x.low, -x.high, 0.0})), std::max(-x.low, x.high), x.canBeNaN};
}

Interval sign(const Interval& x) {
  const auto f = [](double y) { return static_cast<double>((y > 0) - (y < 0)); };
  const Interval result = rising(f, x, 0);
  return x.canBeNaN ? join(result, {-0.0, 0.0, true}) : result;
}

Interval floor(const Interval& x) { return rising(std::floor, x, 0); }

Interval ceil(const Interval& x) { return rising(std::ceil, x, 0); }

Interval round(const Interval& x) { return rising(std::nearbyint, x, 0); }

Interval trunc(const Interval& x) { return rising(std::trunc, x, 0); }

Interval hash(const Interval& h, const Interval& i) {
  const Interval from = floor(h), cell = floor(i);
  // Beyond, float32 has no room for a cell and a place in it.
  for (const Interval& x : {from, cell}) {
    if (x.low < -0x1p24 || x.high > 0x1p24) return Interval::anything(true);
  }
  if (from.isPoint() && cell.isPoint() && !from.canBeNaN && !cell.canBeNaN)
    return ops::hash(from.low, cell.low);
  return {0, ops::hashPrime - 1, from.canBeNaN || cell.canBeNaN};
}

Interval fract(const Interval& x) {
  if (x.isEmpty()) return x;
  const double wholes = std::floor(x.low);
  const bool jumps = wholes != std::floor(x.high);
  if (jumps || x.canBeInfinite()) return {-0.0, 1, x.canBeNaN || x.canBeInfinite()};
  return withZeros(limited(x - wholes, 0, 1));
}

Interval mod(const Interval& x, const Interval& y) {
  if (x.isEmpty() || y.isEmpty()) return nothing();
  if (y.has(0) || x.canBeInfinite() || y.canBeInfinite()) return Interval::anything(true);
  return modulo(x, y);
}

Interval min(const Interval& x, const Interval& y) {
  const bool canBeNaN = x.canBeNaN || y.canBeNaN;
  if (x.isEmpty() || y.isEmpty()) return orOther(nothing(), x, y);
  return orOther(withZeros({std::min(x.low, y.low), std::min(x.high, y.high), canBeNaN}), x, y);
}

Interval max(const Interval& x, const Interval& y) { return -min(-x, -y); }

// Linear in each operand, so that the extremes are where the amount is at one of its ends.
Interval mix(const Interval& x, const Interval& y, const Interval& amount) {
  if (amount.isEmpty()) return amount;
  const auto at = [&](double t) { return x * (1.0 - Interval(t)) + y * t; };
  Interval result = amount.isPoint() ? at(amount.low) : join(at(amount.low), at(amount.high));
  result.canBeNaN |= amount.canBeNaN;
  return result;
}

Interval step(const Interval& edge, const Interval& x) { return ifElse(lt(x, edge), 0.0, 1.0); }

// Comparisons with what is no number are left open, since compilers may turn them round.
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
