#include "detail/base_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "detail/places.hpp"

namespace warpjet {

BaseMesh::BaseMesh(std::vector<Attribute> attributes, std::vector<Corners> triangles)
    : attributes_(std::move(attributes)), triangles_(std::move(triangles)) {
  findSides();
}

void BaseMesh::findSides() {
  places_ = placesOf(attributes_[0].values);
  Pairs edges;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const Corners& corners = triangles_[t];
    std::array<std::uint32_t, 3>& found = sidesOf_.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = inOrder(corners[i], corners[(i + 1) % 3]);
      found[i] = sidesByEnds_.findOrAdd(a, b, static_cast<std::uint32_t>(sides_.size()));
      if (found[i] < sides_.size()) continue;
      const std::uint32_t edge = edges.findOrAdd(places_[a], places_[b], edgeCount_);
      if (edge == edgeCount_) ++edgeCount_;
      sides_.push_back({{a, b}, edge, t});
    }
  }
}

std::array<std::uint32_t, 2> BaseMesh::inOrder(std::uint32_t a, std::uint32_t b) const {
  const bool isInOrder = places_[a] < places_[b] || (places_[a] == places_[b] && a <= b);
  return isInOrder ? std::array{a, b} : std::array{b, a};
}

Weights BaseMesh::onTriangle(std::uint32_t side, const std::array<float, 2>& weights) const {
  const auto& [ends, edge, triangle] = sides_[side];
  const Corners& corners = triangles_[triangle];
  const auto found = std::find(sidesOf_[triangle].begin(), sidesOf_[triangle].end(), side);
  const auto first = static_cast<std::size_t>(found - sidesOf_[triangle].begin());
  const bool isForward = corners[first] == ends[0];
  Weights all{};
  all[first] = weights[isForward ? 0 : 1];
  all[(first + 1) % 3] = weights[isForward ? 1 : 0];
  return all;
}

float BaseMesh::lengthOf(std::uint32_t side) const {
  const auto& [a, b] = sides_[side].ends;
  const float* positions = attributes_[0].values.data();
  float square = 0;
  for (int k = 0; k < 3; ++k) {
    const float difference = positions[3 * a + k] - positions[3 * b + k];
    square += difference * difference;
  }
  return std::sqrt(square);
}

}  // namespace warpjet
