// Invariants of a surface under subdivision: its topology, area and volume. They are computed with
// maps and in double, without code of src/.
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>

#include "mesh/mesh.hpp"
#include "warped.hpp"

namespace warpjet {

using Key = std::array<float, 3>;

inline Key keyOf(const Mesh& mesh, std::uint32_t vertex) {
  return {mesh.positions[3 * vertex], mesh.positions[3 * vertex + 1],
          mesh.positions[3 * vertex + 2]};
}

// Maps an edge, as its two positions, to the numbers of triangles that traverse it forwards (from
// the smaller position to the greater one) and backwards.
using EdgeUses = std::map<std::pair<Key, Key>, std::pair<int, int>>;

inline EdgeUses edgeUses(const Mesh& mesh) {
  EdgeUses uses;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    const Key a = keyOf(mesh, mesh.indices[i]), b = keyOf(mesh, mesh.indices[next]);
    if (a == b) continue;
    ++(a < b ? uses[{a, b}].first : uses[{b, a}].second);
  }
  return uses;
}

// Returns true if every edge has one triangle on each side. At a crack or a T-junction, edges have
// only one triangle.
inline bool isClosed(const Mesh& mesh) {
  for (const auto& [edge, uses] : edgeUses(mesh)) {
    if (uses != std::pair(1, 1)) return false;
  }
  return true;
}

// Returns corners - edges + triangles: 2 for every surface that is topologically a sphere.
inline std::ptrdiff_t eulerCharacteristic(const Mesh& mesh) {
  std::set<Key> corners;
  for (const std::uint32_t i : mesh.indices) corners.insert(keyOf(mesh, i));
  return std::ptrdiff_t(corners.size()) - std::ptrdiff_t(edgeUses(mesh).size()) +
         std::ptrdiff_t(mesh.indices.size() / 3);
}

inline std::array<Point, 3> cornersOf(const Mesh& mesh, std::size_t triangle) {
  const std::uint32_t* const i = mesh.indices.data() + 3 * triangle;
  return {pointOf(mesh.positions, i[0]), pointOf(mesh.positions, i[1]),
          pointOf(mesh.positions, i[2])};
}

// Returns a vector along the normal whose length is twice the area.
inline Point areaVector(const std::array<Point, 3>& corners) {
  return cross(corners[1] - corners[0], corners[2] - corners[0]);
}

inline double totalArea(const Mesh& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i)
    area += length(areaVector(cornersOf(mesh, i))) / 2;
  return area;
}

inline double signedVolume(const Mesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
    const auto corners = cornersOf(mesh, i);
    volume += dot(corners[0], areaVector(corners)) / 6;
  }
  return volume;
}

}  // namespace warpjet
