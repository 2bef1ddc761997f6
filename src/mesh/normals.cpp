#include "mesh/normals.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/buckets.hpp"

namespace warpjet {

namespace {

// For each vertex the first one at its position. 0 and -0 are one place.
std::vector<std::uint32_t> firstsAtPosition(const std::vector<float>& positions) {
  const std::size_t vertices = positions.size() / 3;
  const auto bitsOf = [&](std::size_t vertex) {
    std::array<std::uint32_t, 3> bits{};
    for (int i = 0; i < 3; ++i) {
      const float number = positions[vertex * 3 + i] + 0.0f;
      std::memcpy(&bits[i], &number, sizeof number);
    }
    return bits;
  };
  std::vector<std::uint32_t> firsts(vertices);
  Buckets buckets(vertices);
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    const auto bits = bitsOf(vertex);
    const std::uint64_t hash = mixed(std::uint64_t{bits[0]} << 32 | bits[1], bits[2]);
    firsts[vertex] = buckets.findOrAdd(hash, static_cast<std::uint32_t>(vertex),
                                       [&](std::uint32_t other) { return bitsOf(other) == bits; });
  }
  return firsts;
}

// In double, where not even the squares of the largest floats overflow.
glm::dvec3 positionAt(const Mesh& mesh, std::uint32_t vertex) {
  const float* p = &mesh.positions[std::size_t{vertex} * 3];
  return {p[0], p[1], p[2]};
}

double angleBetween(const glm::dvec3& u, const glm::dvec3& v) {
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

void addTriangle(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners,
                 const std::vector<std::uint32_t>& firsts, std::vector<glm::dvec3>& sums) {
  std::array<glm::dvec3, 3> p;
  for (int i = 0; i < 3; ++i) p[i] = positionAt(mesh, corners[i]);
  // Twice the area long.
  const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  if (normal == glm::dvec3(0)) return;
  for (int i = 0; i < 3; ++i) {
    const double angle = angleBetween(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    sums[firsts[corners[i]]] += angle * normal;
  }
}

}  // namespace

std::vector<float> computeNormals(const Mesh& mesh) {
  const std::vector<std::uint32_t> firsts = firstsAtPosition(mesh.positions);
  std::vector<glm::dvec3> sums(mesh.vertexCount(), glm::dvec3(0));
  for (std::size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
    std::array<std::uint32_t, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      const std::size_t place = triangle * 3 + i;
      corners[i] = mesh.indices.empty() ? static_cast<std::uint32_t>(place) : mesh.indices[place];
    }
    addTriangle(mesh, corners, firsts, sums);
  }
  std::vector<float> normals(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < firsts.size(); ++vertex) {
    const glm::dvec3 sum = sums[firsts[vertex]];
    const double length = glm::length(sum);
    for (int i = 0; i < 3 && length > 0; ++i)
      normals[vertex * 3 + i] = static_cast<float>(sum[i] / length);
  }
  return normals;
}

}  // namespace warpjet
