#include "detail/kinked.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "detail/samples.hpp"

namespace warpjet {

namespace {

// Numbers that differ by less than this share of their range within a triangle are equal.
constexpr float closeness = 1e-4f;

Mask isBetween(Lanes limit, Lanes low, Lanes high) {
  const Lanes margin = closeness * (high - low);
  return logicalAnd(lt(low, limit - margin), gt(high, limit + margin));
}

}  // namespace

Mask areKinked(const BaseMesh& base, const FourTriangles& triangles, const PhaseSamples& phases) {
  Mask found{};
  if (std::none_of(phases.fronts.begin(), phases.fronts.end(), std::mem_fn(&Front::isKink)))
    return found;
  // If the last allowed cut was not enough, the phases of the mesh have not been computed.
  const std::size_t samples = base.sampleOfTriangle(base.triangles().size(), 0);
  if (phases.values.size() != samples * phases.stride()) return found;
  const std::array<SampleIndices, Lanes::count> indices = sampleIndicesOf(base, triangles);
  for (std::size_t i = 0; i < phases.fronts.size(); ++i) {
    const Front& front = phases.fronts[i];
    if (!front.isKink()) continue;
    const float* values = phases.values.data() + phases.firstFront() + i;
    Lanes low = INFINITY, high = -INFINITY;
    for (std::size_t k = 0; k < samplesPerTriangle; ++k) {
      const auto at = [&](std::size_t lane) { return values + phases.stride() * indices[lane][k]; };
      const Lanes value = gather({at(0), at(1), at(2), at(3)});
      low = min(low, value);
      high = max(high, value);
    }
    found = logicalOr(found, isBetween(front.first, low, high));
  }
  return found;
}

}  // namespace warpjet
