#include "mesh/surface/blend.hpp"

#include <cmath>

namespace warpjet {

namespace {

template <std::size_t size>
std::array<float, size> mix(const std::vector<float>& from, const Blend& blend) {
  const auto& [a, b, c] = blend.vertices;
  std::array<float, size> mixed;
  for (std::size_t i = 0; i < size; ++i) {
    mixed[i] = blend.weights[0] * from[size * a + i] + blend.weights[1] * from[size * b + i];
    if (blend.weights[2] != 0) mixed[i] += blend.weights[2] * from[size * c + i];
  }
  return mixed;
}

float lengthOf(const float* p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

// Blends directions: normalizes the first three numbers, and takes the others from the first
// vertex.
template <std::size_t size>
std::array<float, size> mixDirections(const std::vector<float>& from, const Blend& blend) {
  auto mixed = mix<size>(from, blend);
  const float* const first = from.data() + size * blend.vertices[0];
  const float length = lengthOf(mixed.data());
  // Opposite directions rarely cancel exactly.
  const bool cancels = !(length > 1e-6f * lengthOf(first));
  for (std::size_t i = 0; i < 3; ++i) mixed[i] = cancels ? first[i] : mixed[i] / length;
  for (std::size_t i = 3; i < size; ++i) mixed[i] = first[i];
  return mixed;
}

template <std::size_t size>
void append(std::vector<float>& to, const std::array<float, size>& numbers) {
  to.insert(to.end(), numbers.begin(), numbers.end());
}

}  // namespace

void appendBlend(Mesh& to, const Mesh& from, const Blend& blend) {
  append(to.positions, mix<3>(from.positions, blend));
  if (!from.normals.empty()) append(to.normals, mixDirections<3>(from.normals, blend));
  if (!from.uvs.empty()) append(to.uvs, mix<2>(from.uvs, blend));
  if (!from.colors.empty()) append(to.colors, mix<4>(from.colors, blend));
  if (!from.tangents.empty()) append(to.tangents, mixDirections<4>(from.tangents, blend));
  if (!from.painted.empty()) to.painted.push_back(from.painted[blend.vertices[0]]);
  for (std::size_t i = 0; i < from.gradients.size(); ++i) {
    if (!from.gradients[i].empty()) append(to.gradients[i], mix<3>(from.gradients[i], blend));
  }
}

Mesh slice(const Mesh& mesh, std::size_t first, std::size_t end) {
  const auto part = [&](const std::vector<float>& numbers, std::size_t size) {
    if (numbers.empty()) return std::vector<float>{};
    return std::vector<float>(numbers.data() + size * first, numbers.data() + size * end);
  };
  Mesh vertices;
  vertices.positions = part(mesh.positions, 3);
  vertices.normals = part(mesh.normals, 3);
  vertices.uvs = part(mesh.uvs, 2);
  vertices.colors = part(mesh.colors, 4);
  vertices.tangents = part(mesh.tangents, 4);
  for (std::size_t i = 0; i < mesh.gradients.size(); ++i)
    vertices.gradients[i] = part(mesh.gradients[i], 3);
  return vertices;
}

}  // namespace warpjet
