#include "mesh/gltf/triangles.hpp"

#include <cstddef>
#include <utility>

namespace warpjet {

std::size_t trianglesOf(Primitives primitives, std::size_t corners) {
  if (primitives == Primitives::Triangles) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

std::vector<std::uint32_t> separateTriangles(Primitives primitives,
                                             std::vector<std::uint32_t> corners) {
  const std::size_t count = trianglesOf(primitives, corners.size());
  if (primitives == Primitives::Triangles) {
    corners.resize(count * 3);
    return corners;
  }
  std::vector<std::uint32_t> separate;
  separate.reserve(count * 3);
  for (std::size_t i = 0; i < count; ++i) {
    const bool isFan = primitives == Primitives::Fan;
    const std::uint32_t a = corners[isFan ? i + 1 : i];
    const std::uint32_t b = corners[isFan ? i + 2 : i + 1 + i % 2];
    const std::uint32_t c = corners[isFan ? 0 : i + 2 - i % 2];
    if (a != b && b != c && c != a) separate.insert(separate.end(), {a, b, c});
  }
  return separate;
}

void reverseWinding(std::vector<std::uint32_t>& indices, std::size_t from) {
  for (std::size_t i = from; i + 2 < indices.size(); i += 3)
    std::swap(indices[i + 1], indices[i + 2]);
}

}  // namespace warpjet
