#include "detail/division.hpp"

namespace warpjet {

void Division::write(const BaseMesh& base, std::span<const std::uint32_t> pieces,
                     Tessellations& tessellations) {
  attributes.resize(base.attributes().size());
  for (std::size_t i = 0; i < attributes.size(); ++i) {
    const auto& [size, isUnit, values] = base.attributes()[i];
    attributes[i].size = size;
    attributes[i].isUnit = isUnit;
    attributes[i].values.assign(values.begin(), values.end());
  }
  writeSides(base, pieces);
  writeTriangles(base, pieces, tessellations);
}

void Division::writeSides(const BaseMesh& base, std::span<const std::uint32_t> pieces) {
  firstOfSides.clear();
  std::uint32_t vertex = static_cast<std::uint32_t>(base.vertexCount());
  for (const BaseMesh::Side& side : base.sides()) {
    firstOfSides.push_back(vertex);
    const std::uint32_t count = pieces[side.edge];
    const float scale = 1 / static_cast<float>(count);
    for (std::uint32_t i = 1; i < count; ++i, ++vertex) {
      const std::array weights{static_cast<float>(count - i) * scale,
                               static_cast<float>(i) * scale};
      for (std::size_t k = 0; k < attributes.size(); ++k)
        blend(attributes[k], base.attributes()[k], side.ends, weights);
    }
  }
}

void Division::writeTriangles(const BaseMesh& base, std::span<const std::uint32_t> pieces,
                              Tessellations& tessellations) {
  triangles.clear();
  firstTriangles.clear();
  std::vector<std::uint32_t> points;
  for (std::size_t t = 0; t < base.triangles().size(); ++t) {
    firstTriangles.push_back(static_cast<std::uint32_t>(triangles.size()));
    const Corners& corners = base.triangles()[t];
    points.clear();
    SidePieces counts{};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t side = base.sidesOf(t)[i], first = firstOfSides[side];
      const std::uint32_t count = counts[i] = pieces[base.sides()[side].edge];
      const bool isForward = base.startsAt(side, corners[i]);
      points.push_back(corners[i]);
      for (std::uint32_t k = 0; k + 1 < count; ++k)
        points.push_back(first + (isForward ? k : count - 2 - k));
    }
    const Tessellation& tessellation = tessellations.of(counts);
    auto vertex = static_cast<std::uint32_t>(attributes[0].values.size() / 3);
    for (const std::array<float, 3>& weights : tessellation.inner) {
      points.push_back(vertex++);
      for (std::size_t k = 0; k < attributes.size(); ++k)
        blend(attributes[k], base.attributes()[k], corners, weights);
    }
    for (const Corners& each : tessellation.triangles)
      triangles.push_back({points[each[0]], points[each[1]], points[each[2]]});
  }
  firstTriangles.push_back(static_cast<std::uint32_t>(triangles.size()));
}

}  // namespace warpjet
