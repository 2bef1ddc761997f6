#include "detail/places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/surface/weld.hpp"

namespace warpjet {

namespace {

// Vertices at most this far apart along each axis, as a share of the mesh's size, are at one place.
// Some that are up to twice as far apart are, too.
constexpr float closeness = 1e-6f;

float sizeOf(std::span<const float> positions) {
  float size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    float low = INFINITY, high = -INFINITY;
    for (std::size_t i = axis; i < positions.size(); i += 3) {
      if (!std::isfinite(positions[i])) continue;
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    size = std::max(size, high - low);
  }
  return size;
}

// Returns the lowest vertex of the set that contains a vertex.
std::uint32_t setOf(std::vector<std::uint32_t>& sets, std::uint32_t vertex) {
  while (sets[vertex] != vertex) vertex = sets[vertex] = sets[sets[vertex]];
  return vertex;
}

void unite(std::vector<std::uint32_t>& sets, std::uint32_t a, std::uint32_t b) {
  const auto [low, high] = std::minmax({setOf(sets, a), setOf(sets, b)});
  sets[high] = low;
}

}  // namespace

// Any two close vertices share a cell of at least one of eight grids, which are moved by half a
// cell along some axes.
std::vector<std::uint32_t> placesOf(std::span<const float> positions) {
  std::vector<std::uint32_t> sets(positions.size() / 3);
  std::iota(sets.begin(), sets.end(), 0);
  const float size = sizeOf(positions);
  const float scale = size > 0 ? 1 / (2 * closeness * size) : 1;
  for (int grid = 0; grid < 8; ++grid) {
    Welder welder;
    std::vector<std::uint32_t> firsts;  // by cell
    for (std::uint32_t vertex = 0; vertex < sets.size(); ++vertex) {
      Position cell;
      for (int axis = 0; axis < 3; ++axis)
        cell[axis] = std::floor(positions[3 * vertex + axis] * scale +
                                ((grid >> axis & 1) != 0 ? 0.5f : 0.0f));
      const std::uint32_t number = welder.weld(cell);
      if (number == firsts.size()) firsts.push_back(vertex);
      unite(sets, firsts[number], vertex);
    }
  }
  for (std::uint32_t vertex = 0; vertex < sets.size(); ++vertex) sets[vertex] = setOf(sets, vertex);
  return sets;
}

}  // namespace warpjet
