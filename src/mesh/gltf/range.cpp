#include "mesh/gltf/range.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet {

namespace {

// Tolerances for rounding to floats, and for three digits or eight bits.
constexpr double exactly = 1e-6, nearly = 1e-2;

}  // namespace

void clampColors(Gltf& gltf, std::vector<float>& colors, std::size_t first) {
  bool isSeen = false;
  for (std::size_t i = first; i < colors.size(); ++i) {
    const float part = colors[i];
    if ((part >= 0 && part <= 1) || !std::isfinite(part)) continue;
    colors[i] = std::clamp(part, 0.0f, 1.0f);
    isSeen = true;
  }
  if (isSeen) gltf.warn("Colours of vertices outside 0 to 1 are clamped.");
}

bool makeUnit(std::vector<float>& vectors, std::size_t first, std::size_t stride) {
  bool isSeen = false;
  for (std::size_t i = first; i < vectors.size(); i += stride) {
    float* const vector = &vectors[i];
    const double length = std::hypot(double{vector[0]}, double{vector[1]}, double{vector[2]});
    if (!(length > 0) || !std::isfinite(length) || std::abs(length - 1) <= exactly) continue;
    isSeen |= std::abs(length - 1) > nearly;
    for (int k = 0; k < 3; ++k) vector[k] = static_cast<float>(vector[k] / length);
  }
  return isSeen;
}

void makeUnit(Gltf& gltf, std::vector<float>& vectors, std::size_t first, std::size_t stride,
              const std::string& name) {
  if (makeUnit(vectors, first, stride))
    gltf.warn(name + " that are not of length 1 are scaled to it.");
}

}  // namespace warpjet
