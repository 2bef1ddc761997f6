#include "mesh/gltf/range.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet {

namespace {

// Lengths that differ from 1 by rounding to floats keep their bits. Lengths that differ by more
// than rounding to three digits or eight bits cause a warning.
constexpr double floatTolerance = 1e-6, visibleTolerance = 1e-2;

}  // namespace

void clampColors(Gltf& gltf, std::vector<float>& colors, std::size_t first) {
  bool isVisible = false;
  for (std::size_t i = first; i < colors.size(); ++i) {
    const float channel = colors[i];
    if ((channel >= 0 && channel <= 1) || !std::isfinite(channel)) continue;
    colors[i] = std::clamp(channel, 0.0f, 1.0f);
    isVisible = true;
  }
  if (isVisible) gltf.warn("Colours of vertices outside 0 to 1 are clamped.");
}

bool makeUnit(std::vector<float>& vectors, std::size_t first, std::size_t stride) {
  bool isVisible = false;
  for (std::size_t i = first; i < vectors.size(); i += stride) {
    float* const vector = &vectors[i];
    const double length = std::hypot(double{vector[0]}, double{vector[1]}, double{vector[2]});
    if (!(length > 0) || !std::isfinite(length) || std::abs(length - 1) <= floatTolerance) continue;
    isVisible |= std::abs(length - 1) > visibleTolerance;
    for (int k = 0; k < 3; ++k) vector[k] = static_cast<float>(vector[k] / length);
  }
  return isVisible;
}

void makeUnit(Gltf& gltf, std::vector<float>& vectors, std::size_t first, std::size_t stride,
              const std::string& name) {
  if (makeUnit(vectors, first, stride))
    gltf.warn(name + " that are not of length 1 are scaled to it.");
}

}  // namespace warpjet
