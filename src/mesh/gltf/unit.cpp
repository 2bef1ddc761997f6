#include "mesh/gltf/unit.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec3.hpp>

namespace warpjet {

namespace {

// The max deviation of a length from 1: a fifth of what gltf-validator allows, many times the
// rounding of float32.
constexpr double tolerance = 1e-4;

glm::dvec3 at(const std::vector<float>& numbers, std::size_t place) {
  return glm::dvec3(glm::make_vec3(&numbers[place]));
}

void put(std::vector<float>& numbers, std::size_t place, glm::dvec3 value) {
  for (int i = 0; i < 3; ++i) numbers[place + i] = static_cast<float>(value[i]);
}

// In double, the square of a float32 neither overflows nor underflows.
bool isUnit(glm::dvec3 v) { return std::abs(glm::length(v) - 1) <= tolerance; }

bool hasDirection(glm::dvec3 v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length);
}

// Returns the area-weighted normals of the triangles around each vertex.
std::vector<glm::dvec3> triangleNormals(const Mesh& mesh) {
  std::vector<glm::dvec3> sums(mesh.vertexCount());
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
    const auto corners = mesh.corners(i);
    const glm::dvec3 a = at(mesh.positions, std::size_t{3} * corners[0]);
    const glm::dvec3 b = at(mesh.positions, std::size_t{3} * corners[1]);
    const glm::dvec3 c = at(mesh.positions, std::size_t{3} * corners[2]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    for (const std::uint32_t corner : corners) sums[corner] += normal;
  }
  return sums;
}

glm::dvec3 anyPerpendicular(glm::dvec3 normal) {
  const glm::dvec3 axis = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, axis));
}

}  // namespace

std::vector<float> unitNormals(const Mesh& mesh) {
  std::vector<float> normals = mesh.normals;
  std::vector<glm::dvec3> substitutes;
  for (std::size_t i = 0; i < normals.size(); i += 3) {
    glm::dvec3 normal = at(normals, i);
    if (isUnit(normal)) continue;
    if (!hasDirection(normal)) {
      if (substitutes.empty()) substitutes = triangleNormals(mesh);
      normal = substitutes[i / 3];
    }
    put(normals, i, hasDirection(normal) ? glm::normalize(normal) : glm::dvec3(0, 0, 1));
  }
  return normals;
}

std::vector<float> unitTangents(const std::vector<float>& tangents,
                                const std::vector<float>& normals) {
  std::vector<float> results = tangents;
  for (std::size_t vertex = 0; 4 * vertex < results.size(); ++vertex) {
    const glm::dvec3 tangent = at(results, 4 * vertex);
    if (!isUnit(tangent))
      put(results, 4 * vertex,
          hasDirection(tangent) ? glm::normalize(tangent)
                                : anyPerpendicular(at(normals, 3 * vertex)));
    float& sign = results[4 * vertex + 3];
    sign = sign < 0 ? -1.0F : 1.0F;
  }
  return results;
}

}  // namespace warpjet
