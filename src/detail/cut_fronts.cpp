#include "detail/cut_fronts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "detail/front_scale.hpp"
#include "detail/samples.hpp"

namespace warpjet {

namespace {

// The max change of a front within a triangle, on its scale.
constexpr double maxChange = 1.1;

// Edges that are this many times shorter than the max length are not cut at fronts: a mesh has
// about a thousand of them across, so that narrower steps look like jumps.
constexpr float maxShortening = 128;
constexpr float maxShorteningAtKinks = 8;

using Numbers = std::array<double, samplesPerTriangle>;

// The ranges of a front within a triangle. A front that isn't finite everywhere has empty ones.
struct FrontInTriangle {
  ValueRange inside, sampled;
  std::array<ValueRange, 3> alongSides;
};

ValueRange rangeInside(const Numbers& numbers) {
  ValueRange range;
  for (const Cell& cell : cells) {
    const auto& [corners, middles] = cell;
    // The middles of a cell belong to its sides 0 to 1, 1 to 2, and 0 to 2.
    range.add(rangeOnTriangle({numbers[corners[0]], numbers[corners[1]], numbers[corners[2]]},
                              {numbers[middles[0]], numbers[middles[1]], numbers[middles[2]]}));
  }
  return range;
}

ValueRange rangeAlong(const Numbers& numbers, const std::array<int, sampleIntervals + 1>& side) {
  ValueRange range;
  for (int i = 0; i + 2 <= sampleIntervals; ++i)
    range.add(rangeOnSegment(numbers[side[i]], numbers[side[i + 1]], numbers[side[i + 2]]));
  return range;
}

FrontInTriangle findRanges(const Numbers& numbers) {
  FrontInTriangle front;
  const auto isFinite = [](double number) { return std::isfinite(number); };
  if (!std::all_of(numbers.begin(), numbers.end(), isFinite)) return front;
  for (const double number : numbers) front.sampled.add(number);
  front.inside = rangeInside(numbers);
  for (int i = 0; i < 3; ++i) front.alongSides[i] = rangeAlong(numbers, sideSamples[i]);
  return front;
}

std::vector<FrontInTriangle> findRanges(const BaseMesh& base, const PhaseSamples& samples,
                                        std::uint32_t offset) {
  std::vector<FrontInTriangle> all;
  all.reserve(base.triangles().size());
  for (std::size_t t = 0; t < base.triangles().size(); ++t) {
    Numbers numbers;
    const SampleIndices indices = sampleIndicesOf(base, t);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = samples.values[samples.stride() * indices[i] + offset];
    all.push_back(findRanges(numbers));
  }
  return all;
}

FrontScale scaleOf(const Front& front, const std::vector<FrontInTriangle>& ranges) {
  ValueRange estimated, sampled;
  for (const FrontInTriangle& each : ranges) {
    estimated.add(each.inside);
    sampled.add(each.sampled);
  }
  return {front, estimated, sampled};
}

// Returns which sides to halve: those along which the front changes about as much as within the
// triangle, or all if it changes only inside.
std::array<bool, 3> sidesToHalve(const FrontInTriangle& front, const FrontScale& scale) {
  const double change = front.inside.isEmpty() ? 0 : scale.changeWithin(front.inside);
  if (change <= maxChange) return {};
  std::array<bool, 3> sides{};
  for (int i = 0; i < 3; ++i) sides[i] = scale.changeWithin(front.alongSides[i]) > 0.5 * change;
  const bool isInside = std::none_of(sides.begin(), sides.end(), [](bool is) { return is; });
  return isInside ? std::array{true, true, true} : sides;
}

}  // namespace

std::vector<bool> edgesToHalve(const BaseMesh& base, const PhaseSamples& samples, float maxLength,
                               CutCreases cutCreases) {
  std::vector<bool> edges(base.edgeCount());
  for (std::size_t i = 0; i < samples.fronts.size(); ++i) {
    const Front& front = samples.fronts[i];
    if (front.isCrease() && (cutCreases == CutCreases::No || !front.isStill())) continue;
    const float minLength =
        maxLength / (front.profile == Profile::Kink ? maxShorteningAtKinks : maxShortening);
    const auto offset = static_cast<std::uint32_t>(samples.firstFront() + i);
    const std::vector<FrontInTriangle> ranges = findRanges(base, samples, offset);
    const FrontScale scale = scaleOf(front, ranges);
    for (std::size_t t = 0; t < ranges.size(); ++t) {
      const std::array<bool, 3> sides = sidesToHalve(ranges[t], scale);
      for (int k = 0; k < 3; ++k) {
        if (sides[k] && base.lengthOf(base.sidesOf(t)[k]) >= minLength)
          edges[base.edgeOf(t, k)] = true;
      }
    }
  }
  return edges;
}

}  // namespace warpjet
