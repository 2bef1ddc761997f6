#include "detail/cut_lengths.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "detail/cut_fronts.hpp"

namespace warpjet {

namespace {

// The approximate max number of triangles of a cut mesh: a frame has time for about four
// evaluations of a warp for each of them.
constexpr double maxCutTriangles = 1 << 16;

// The approximate max number of triangles of a mesh that is cut at creases.
constexpr double maxTrianglesAtCreases = 1 << 14;

// Returns the distance of two points with `size` coordinates.
float distanceOf(const float* a, const float* b, std::uint32_t size) {
  float sum = 0;
  for (std::uint32_t i = 0; i < size; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

// Returns the largest change of a phase along a side, in its steps.
float changeAlong(const BaseMesh& base, std::uint32_t side, const PhaseSamples& samples) {
  const auto& ends = base.sides()[side].ends;
  const std::uint32_t first = base.sampleOfSide(side, 0);
  const std::array points{ends[0], first, first + 1, first + 2, ends[1]};
  const std::uint32_t stride = samples.stride();
  std::uint32_t offset = 0;
  float max = 0;
  for (std::size_t k = 0; k < samples.sizes.size(); ++k) {
    float change = 0;
    for (std::size_t j = 0; j + 1 < points.size(); ++j)
      change +=
          distanceOf(samples.values.data() + stride * points[j] + offset,
                     samples.values.data() + stride * points[j + 1] + offset, samples.sizes[k]);
    if (std::isfinite(change)) max = std::max(max, change / samples.steps[k]);
    offset += samples.sizes[k];
  }
  return max;
}

// The number of triangles grows with the square of the numbers of pieces.
double countTriangles(const BaseMesh& base, const std::vector<float>& lengths) {
  double triangles = 0;
  for (std::size_t t = 0; t < base.triangles().size(); ++t) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += std::max(1.0f, lengths[base.edgeOf(t, i)]);
    triangles += sum * sum / 9;
  }
  return triangles;
}

}  // namespace

std::vector<float> cutLengths(const BaseMesh& base, const PhaseSamples& samples, float maxLength) {
  std::vector<float> lengths(base.edgeCount());
  for (std::uint32_t side = 0; side < base.sides().size(); ++side) {
    float& length = lengths[base.sides()[side].edge];
    length = std::max({length, base.lengthOf(side) / maxLength, changeAlong(base, side, samples)});
  }
  const double triangles = countTriangles(base, lengths);
  const auto scale = static_cast<float>(std::sqrt(std::min(1.0, maxCutTriangles / triangles)));
  for (float& length : lengths) length *= scale;
  if (samples.fronts.empty() || samples.areFrontsSettled()) return lengths;
  const auto cutAlso = [&](CutCreases cutCreases, double maxTriangles) {
    std::vector<float> longer = lengths;
    const std::vector<bool> halved = edgesToHalve(base, samples, maxLength, cutCreases);
    for (std::size_t edge = 0; edge < lengths.size(); ++edge)
      if (halved[edge]) longer[edge] = std::max(2.0f, lengths[edge]);
    const bool areFew = countTriangles(base, longer) <= maxTriangles;
    return areFew ? std::optional(std::move(longer)) : std::nullopt;
  };
  if (samples.hasCreasesToCut()) {
    if (auto cut = cutAlso(CutCreases::Yes, maxTrianglesAtCreases)) return *std::move(cut);
  }
  return cutAlso(CutCreases::No, maxCutTriangles).value_or(std::move(lengths));
}

}  // namespace warpjet
