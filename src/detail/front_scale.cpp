#include "detail/front_scale.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace warpjet {

namespace {

// The part of a step that a triangle may contain.
constexpr double shareOfStep = 0.5;

// Wider steps, as a share of the range on the mesh, show at the samples of an uncut mesh, and so do
// the peaks of an exponential whose exponent has a shorter range, and of the inverse of numbers
// with a smaller quotient. With both, exp(-x^2) and 1 / (1 + x^2) are as wide as an eighth of the
// mesh.
constexpr double maxWidth = 0.125;
constexpr double minExponents = 16;
constexpr double minQuotient = 16;

// A peak f is measured by the root of f / max f, since then a part of the scale anywhere errs about
// equally if it is drawn straight: f'' is proportional to f for an exponential.
constexpr double partsOfPeak = 4;

// atan is measured by asinh of its argument, up to where it is within 1% of its ends.
constexpr double stepOfArctangent = 1.5;
constexpr double endOfArctangent = 5.3;

// A power is a pole, which has no height, if the smallest number is less than this share of the
// largest one.
constexpr double minShare = 1e-5;

// Numbers that differ by less than this share of the range on the mesh are equal.
constexpr double rounding = 1e-6;

// The following functions are continuous, increasing, and within 1% of their names. In wasm, those
// of the standard library would call JavaScript, which allocates an object for each result.
double exp2(double x) {
  const double clamped = std::clamp(x, -126.0, 126.0), whole = std::floor(clamped);
  const double part = clamped - whole;
  return std::ldexp(1 + part * (0.6565 + 0.3435 * part), static_cast<int>(whole));
}

double log2(double x) {
  int exponent = 0;
  const double part = 2 * std::frexp(x, &exponent) - 1;
  return exponent - 1 + part * (1.3465 - 0.3465 * part);
}

double asinh(double x) {
  return std::copysign(log2(std::abs(x) + std::sqrt(x * x + 1)) * std::numbers::ln2, x);
}

}  // namespace

FrontScale::FrontScale(const Front& front, const ValueRange& estimated, const ValueRange& sampled)
    : profile_(front.profile), first_(front.first) {
  switch (profile_) {
    case Profile::Step:
      first_ = std::isfinite(front.first) ? front.first : estimated.low;
      second_ = std::isfinite(front.second) ? front.second : estimated.high;
      isUsed_ = first_ < second_ && second_ - first_ < maxWidth * estimated.length();
      break;
    case Profile::Exponential:
      second_ = first_ > 0 ? estimated.high : estimated.low;
      isUsed_ = std::abs(first_) * estimated.length() > minExponents;
      break;
    case Profile::Power:
      if (first_ > 0) {
        second_ = estimated.high;
        break;
      }
      // The estimate of a number that is not quadratic can be too low, even negative.
      second_ = std::max(estimated.low, sampled.low / 4);
      isUsed_ = sampled.low > minShare * sampled.high && estimated.high > minQuotient * second_;
      break;
    case Profile::Arctangent:
      break;
    case Profile::Kink:
    case Profile::Cusp:
      closeness_ = rounding * sampled.length();
      break;
  }
}

double FrontScale::at(double number) const {
  if (!isUsed_) return 0;
  switch (profile_) {
    case Profile::Step: {
      const double step = shareOfStep * (second_ - first_);
      return std::clamp(number, first_ - step, second_ + step) / step;
    }
    case Profile::Exponential:
      return partsOfPeak * exp2(0.5 * first_ * std::numbers::log2e * (number - second_));
    case Profile::Power:
      // The root of the power, which is 1 at its peak, and not larger elsewhere.
      return number <= 0 ? (first_ > 0 ? 0 : partsOfPeak)
                         : partsOfPeak * exp2(std::min(0.0, 0.5 * first_ * log2(number / second_)));
    case Profile::Arctangent:
      return std::clamp(asinh(number), -endOfArctangent, endOfArctangent) / stepOfArctangent;
    case Profile::Kink:
      // A part that begins or ends at the kink changes by 1, which is allowed.
      return std::abs(number - first_) <= closeness_ ? 1 : (number < first_ ? 0 : 2);
    case Profile::Cusp:
      return number <= first_ + closeness_ ? 0 : 2;
  }
  return 0;
}

}  // namespace warpjet
