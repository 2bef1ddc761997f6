#include "detail/interpolation.hpp"

#include <algorithm>
#include <cmath>

namespace warpjet {

namespace {

// Normalizes the vector of one vertex in place. Leaves it as it is if it is zero or not finite.
void normalize(float* numbers, std::uint32_t size) {
  float square = 0;
  for (std::uint32_t i = 0; i < size; ++i) square += numbers[i] * numbers[i];
  const float scale = 1 / std::sqrt(square);
  if (!std::isfinite(scale) || scale == 0) return;
  for (std::uint32_t i = 0; i < size; ++i) numbers[i] *= scale;
}

// Appends a weighted sum of vertices of `from`.
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

void replaceLast(Attribute& attribute, glm::vec3 value) {
  std::copy_n(&value[0], 3, attribute.values.end() - 3);
}

}  // namespace

void Interpolation::appendOnSide(std::vector<Attribute>& to, std::uint32_t side,
                                 const std::array<float, 2>& weights) const {
  const auto& [ends, edge, triangle] = base_.sides()[side];
  for (std::size_t k = 0; k < to.size(); ++k) blend(to[k], base_.attributes()[k], ends, weights);
  if (isCurved()) curve(to, triangle, base_.onTriangle(side, weights));
}

void Interpolation::appendInside(std::vector<Attribute>& to, std::size_t triangle,
                                 const Weights& weights) const {
  const Corners& corners = base_.triangles()[triangle];
  for (std::size_t k = 0; k < to.size(); ++k) blend(to[k], base_.attributes()[k], corners, weights);
  if (isCurved()) curve(to, triangle, weights);
}

Weights Interpolation::onPatch(std::size_t triangle, const Weights& weights) const {
  Weights sum{};
  for (int corner = 0; corner < 3; ++corner)
    for (int i = 0; i < 3; ++i) sum[i] += weights[corner] * patches_[triangle].corners[corner][i];
  return sum;
}

void Interpolation::curve(std::vector<Attribute>& to, std::size_t triangle,
                          const Weights& weights) const {
  const Weights patchWeights = onPatch(triangle, weights);
  const std::uint32_t patch = patches_[triangle].triangle;
  replaceLast(to[0], surface_->position(patch, patchWeights));
  replaceLast(to[surface_->normals()], surface_->normal(patch, patchWeights));
}

std::vector<Attribute> Interpolation::samples() const {
  std::vector<Attribute> all(base_.attributes().begin(), base_.attributes().end());
  for (std::uint32_t side = 0; side < base_.sides().size(); ++side)
    for (const float weight : {0.25f, 0.5f, 0.75f}) appendOnSide(all, side, {1 - weight, weight});
  for (std::size_t t = 0; t < base_.triangles().size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      Weights weights{0.25f, 0.25f, 0.25f};
      weights[i] = 0.5f;
      appendInside(all, t, weights);
    }
  }
  return all;
}

std::vector<Patch> makeWholePatches(std::size_t triangles) {
  std::vector<Patch> patches;
  for (std::uint32_t t = 0; t < triangles; ++t)
    patches.push_back({t, {Weights{1, 0, 0}, Weights{0, 1, 0}, Weights{0, 0, 1}}});
  return patches;
}

}  // namespace warpjet
