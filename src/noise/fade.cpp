#include <numbers>

#include "noise/bodies.hpp"

namespace warpjet {

namespace {

// Noise keeps its full strength where a wave covers at least this number of pixels.
constexpr double pixelsPerWave = 4;

}  // namespace

// Returns a value between `value` and `mean`. The mean of a sine over a square whose sides have
// `share` of its wavelength is about exp(-(pi share)^2 / 6) of its value in the middle, to the
// second order of sin(x) / x. This factor is divided by its value at 1 / pixelsPerWave, so that
// fading begins there continuously.
Expression fade(Expression value, double mean, Expression pixel, double wavelength) {
  constexpr double decay = std::numbers::pi * std::numbers::pi / 6;
  const Expression share = pixel / wavelength;
  const Expression excess = max(share * share - 1 / (pixelsPerWave * pixelsPerWave), 0.0);
  return mean + (value - mean) * exp(-decay * excess);
}

}  // namespace warpjet
