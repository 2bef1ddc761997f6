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

std::array<SampleIndices, Lanes::count> sampleIndicesOf(const BaseMesh& base,
                                                        const FourTriangles& triangles) {
  std::array<SampleIndices, Lanes::count> indices;
  for (std::size_t lane = 0; lane < triangles.size(); ++lane)
    indices[lane] = sampleIndicesOf(base, triangles[lane]);
  return indices;
}

Samples samplesOf(const BaseMesh& base, const FourTriangles& triangles,
                  std::span<const float> warped) {
  const std::array<SampleIndices, Lanes::count> indices = sampleIndicesOf(base, triangles);
  Samples samples;
  const auto at = [&](std::size_t lane, std::size_t i) {
    return warped.data() + 3 * indices[lane][i];
  };
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = gatherVectors({at(0, i), at(1, i), at(2, i), at(3, i)});
  return samples;
}

}  // namespace warpjet
