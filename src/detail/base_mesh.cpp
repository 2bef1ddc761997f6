#include "detail/base_mesh.hpp"

#include <cmath>
#include <utility>

#include "mesh/surface/weld.hpp"

namespace warpjet {

namespace {

// Makes numbers of one vertex a unit vector, unless they are zero or not finite.
void normalize(float* numbers, std::uint32_t size) {
  float square = 0;
  for (std::uint32_t i = 0; i < size; ++i) square += numbers[i] * numbers[i];
  const float scale = 1 / std::sqrt(square);
  if (!std::isfinite(scale) || scale == 0) return;
  for (std::uint32_t i = 0; i < size; ++i) numbers[i] *= scale;
}

}  // namespace

BaseMesh::BaseMesh(std::vector<Attribute> attributes, std::vector<Corners> triangles)
    : attributes_(std::move(attributes)), triangles_(std::move(triangles)) {
  findSides();
}

void BaseMesh::findSides() {
  Welder welder;
  places_.resize(vertexCount());
  const float* p = attributes_[0].values.data();
  for (std::uint32_t& place : places_) {
    place = welder.weld({p[0], p[1], p[2]});
    p += 3;
  }
  Pairs edges;
  for (const Corners& corners : triangles_) {
    std::array<std::uint32_t, 3>& found = sidesOf_.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = inOrder(corners[i], corners[(i + 1) % 3]);
      found[i] = sidesByEnds_.findOrAdd(a, b, static_cast<std::uint32_t>(sides_.size()));
      if (found[i] < sides_.size()) continue;
      const std::uint32_t edge = edges.findOrAdd(places_[a], places_[b], edgeCount_);
      if (edge == edgeCount_) ++edgeCount_;
      sides_.push_back({{a, b}, edge});
    }
  }
}

std::array<std::uint32_t, 2> BaseMesh::inOrder(std::uint32_t a, std::uint32_t b) const {
  const bool isInOrder = places_[a] < places_[b] || (places_[a] == places_[b] && a <= b);
  return isInOrder ? std::array{a, b} : std::array{b, a};
}

std::vector<Attribute> BaseMesh::samples() const {
  std::vector<Attribute> all = attributes_;
  for (std::size_t k = 0; k < all.size(); ++k) {
    for (const Side& side : sides_) {
      for (const float weight : {0.25f, 0.5f, 0.75f})
        blend(all[k], attributes_[k], side.ends, std::array{1 - weight, weight});
    }
    for (const Corners& corners : triangles_) {
      for (int i = 0; i < 3; ++i) {
        std::array weights{0.25f, 0.25f, 0.25f};
        weights[i] = 0.5f;
        blend(all[k], attributes_[k], corners, weights);
      }
    }
  }
  return all;
}

template <std::size_t count>
void blend(Attribute& to, const Attribute& from, const std::array<std::uint32_t, count>& vertices,
           const std::array<float, count>& weights) {
  const std::size_t end = to.values.size();
  to.values.resize(end + to.size);
  for (std::uint32_t i = 0; i < to.size; ++i) {
    float sum = 0;
    for (std::size_t k = 0; k < count; ++k)
      sum += weights[k] * from.values[vertices[k] * to.size + i];
    to.values[end + i] = sum;
  }
  if (to.isUnit) normalize(to.values.data() + end, to.size);
}

template void blend<2>(Attribute&, const Attribute&, const std::array<std::uint32_t, 2>&,
                       const std::array<float, 2>&);
template void blend<3>(Attribute&, const Attribute&, const std::array<std::uint32_t, 3>&,
                       const std::array<float, 3>&);

}  // namespace warpjet
