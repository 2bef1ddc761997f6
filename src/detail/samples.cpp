#include "detail/samples.hpp"

#include <cstdint>

namespace warpjet {

SampleIndices sampleIndicesOf(const BaseMesh& base, std::size_t triangle) {
  constexpr int end = sampleIntervals;
  const Corners& corners = base.triangles()[triangle];
  SampleIndices indices{};
  for (int i = 0; i < 3; ++i) indices[cornerSamples[i]] = corners[i];
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t side = base.sidesOf(triangle)[i];
    for (int k = 1; k < end; ++k) {
      const int indexOnSide = base.startsAt(side, corners[i]) ? k - 1 : end - 1 - k;
      indices[sideSamples[i][k]] = base.sampleOfSide(side, indexOnSide);
    }
  }
  indices[sampleAt(2, 1)] = base.sampleOfTriangle(triangle, 0);
  indices[sampleAt(3, 1)] = base.sampleOfTriangle(triangle, 1);
  indices[sampleAt(3, 2)] = base.sampleOfTriangle(triangle, 2);
  return indices;
}

Samples samplesOf(const BaseMesh& base, std::size_t triangle, std::span<const float> warped) {
  const SampleIndices indices = sampleIndicesOf(base, triangle);
  Samples samples;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float* position = warped.data() + 3 * indices[i];
    samples[i] = {position[0], position[1], position[2]};
  }
  return samples;
}

}  // namespace warpjet
