#include "detail/division.hpp"

#include <tuple>
#include <utility>

namespace warpjet {

namespace {

// Returns the weights of both ends of a side at point i of those that divide it into `count`
// pieces.
std::pair<float, float> weightsAt(std::uint32_t i, std::uint32_t count) {
  const float scale = 1 / static_cast<float>(count);
  return {static_cast<float>(count - i) * scale, static_cast<float>(i) * scale};
}

}  // namespace

SidePieces piecesOf(const BaseMesh& base, std::size_t triangle,
                    std::span<const std::uint32_t> pieces) {
  SidePieces counts{};
  for (int i = 0; i < 3; ++i) counts[i] = pieces[base.edgeOf(triangle, i)];
  return counts;
}

void Division::write(const Interpolation& interpolation, std::span<const std::uint32_t> pieces,
                     Tessellations& tessellations, std::span<const SquaredSides> sides) {
  const std::span<const Attribute> baseAttributes = interpolation.base().attributes();
  attributes.resize(baseAttributes.size());
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const auto& [size, isUnit, values] = baseAttributes[i];
    attributes[i].size = size;
    attributes[i].isUnit = isUnit;
    attributes[i].values.assign(values.begin(), values.end());
  }
  writeSides(interpolation, pieces);
  writeTriangles(interpolation, pieces, tessellations, sides);
}

void Division::writeSides(const Interpolation& interpolation,
                          std::span<const std::uint32_t> pieces) {
  const BaseMesh& base = interpolation.base();
  firstVertices.clear();
  auto vertex = static_cast<std::uint32_t>(base.vertexCount());
  for (std::uint32_t side = 0; side < base.sides().size(); ++side) {
    firstVertices.push_back(vertex);
    const std::uint32_t count = pieces[base.sides()[side].edge];
    for (std::uint32_t i = 1; i < count; ++i, ++vertex) {
      const auto [start, end] = weightsAt(i, count);
      interpolation.appendOnSide(attributes, side, {start, end});
    }
  }
}

void Division::writeTriangles(const Interpolation& interpolation,
                              std::span<const std::uint32_t> pieces, Tessellations& tessellations,
                              std::span<const SquaredSides> sides) {
  const BaseMesh& base = interpolation.base();
  triangles.clear();
  firstTriangles.clear();
  std::vector<std::uint32_t> points;
  for (std::size_t t = 0; t < base.triangles().size(); ++t) {
    firstTriangles.push_back(static_cast<std::uint32_t>(triangles.size()));
    const Corners& corners = base.triangles()[t];
    const SidePieces counts = piecesOf(base, t, pieces);
    points.clear();
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t side = base.sidesOf(t)[i], first = firstVertices[side];
      const bool isForward = base.startsAt(side, corners[i]);
      points.push_back(corners[i]);
      for (std::uint32_t k = 0; k + 1 < counts[i]; ++k)
        points.push_back(first + (isForward ? k : counts[i] - 2 - k));
    }
    const Tessellation& tessellation = tessellations.get(counts);
    auto vertex = static_cast<std::uint32_t>(attributes[0].values.size() / 3);
    for (const Weights& weights : tessellation.inner) {
      points.push_back(vertex++);
      interpolation.appendInside(attributes, t, weights);
    }
    const SquaredSides squares = sides.empty() ? SquaredSides{} : sides[t];
    for (std::size_t i = 0; i < tessellation.triangles.size(); ++i) {
      const Corners each =
          withShorterDiagonal(tessellation.triangles, tessellation.flips, i, squares);
      triangles.push_back({points[each[0]], points[each[1]], points[each[2]]});
    }
  }
  firstTriangles.push_back(static_cast<std::uint32_t>(triangles.size()));
}

std::vector<Patch> dividePatches(const Interpolation& interpolation,
                                 std::span<const std::uint32_t> pieces,
                                 Tessellations& tessellations) {
  std::vector<Patch> patches;
  std::vector<Weights> points;
  for (std::size_t t = 0; t < interpolation.base().triangles().size(); ++t) {
    const SidePieces counts = piecesOf(interpolation.base(), t, pieces);
    const Tessellation& tessellation = tessellations.get(counts);
    points.clear();
    for (int i = 0; i < 3; ++i) {
      for (std::uint32_t k = 0; k < counts[i]; ++k) {
        Weights weights{};
        std::tie(weights[i], weights[(i + 1) % 3]) = weightsAt(k, counts[i]);
        points.push_back(interpolation.onPatch(t, weights));
      }
    }
    for (const Weights& weights : tessellation.inner)
      points.push_back(interpolation.onPatch(t, weights));
    for (const auto& [a, b, c] : tessellation.triangles)
      patches.push_back({interpolation.patchOf(t), {points[a], points[b], points[c]}});
  }
  return patches;
}

}  // namespace warpjet
