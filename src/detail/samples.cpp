#include "detail/samples.hpp"

#include <cstdint>

namespace warpjet {

Samples samplesOf(const BaseMesh& base, std::size_t triangle, std::span<const float> warped) {
  const auto read = [&](std::uint32_t sample) {
    return glm::vec3(warped[3 * sample], warped[3 * sample + 1], warped[3 * sample + 2]);
  };
  constexpr int end = sampleIntervals;
  const Corners& corners = base.triangles()[triangle];
  Samples samples;
  for (int i = 0; i < 3; ++i) samples[cornerSamples[i]] = read(corners[i]);
  for (int k = 1; k < end; ++k) {
    const std::array places{sampleAt(k, 0), sampleAt(end, k), sampleAt(end - k, end - k)};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t side = base.sidesOf(triangle)[i];
      const int indexOnSide = base.startsAt(side, corners[i]) ? k - 1 : end - 1 - k;
      samples[places[i]] = read(base.sampleOfSide(side, indexOnSide));
    }
  }
  samples[sampleAt(2, 1)] = read(base.sampleOfTriangle(triangle, 0));
  samples[sampleAt(3, 1)] = read(base.sampleOfTriangle(triangle, 1));
  samples[sampleAt(3, 2)] = read(base.sampleOfTriangle(triangle, 2));
  return samples;
}

}  // namespace warpjet
