#include "mesh/surface/normals.hpp"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/surface/sheets.hpp"
#include "mesh/surface/weld.hpp"

namespace warpjet {

namespace {

// For each vertex the number of its position.
std::vector<std::uint32_t> weldedVertices(const std::vector<float>& positions) {
  Welder welder;
  std::vector<std::uint32_t> welded;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    welded.push_back(welder.weld({positions[i], positions[i + 1], positions[i + 2]}));
  return welded;
}

// In double, where not even the squares of the largest floats overflow.
glm::dvec3 positionAt(const Mesh& mesh, std::uint32_t vertex) {
  const float* p = &mesh.positions[std::size_t{vertex} * 3];
  return {p[0], p[1], p[2]};
}

double angleBetween(const glm::dvec3& u, const glm::dvec3& v) {
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

// To the sums of what its corners are numbered.
void addTriangle(const Mesh& mesh, const std::array<std::uint32_t, 3>& corners,
                 const std::vector<std::uint32_t>& numbers, std::vector<glm::dvec3>& sums) {
  std::array<glm::dvec3, 3> p;
  for (int i = 0; i < 3; ++i) p[i] = positionAt(mesh, corners[i]);
  // Twice the area long.
  const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
  if (normal == glm::dvec3(0)) return;
  for (int i = 0; i < 3; ++i) {
    const double angle = angleBetween(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    sums[numbers[corners[i]]] += angle * normal;
  }
}

}  // namespace

std::vector<float> computeNormals(const Mesh& mesh) {
  const std::vector<std::uint32_t> places = weldedVertices(mesh.positions);
  const Sheets sheets = findSheets(mesh, places);
  std::vector<glm::dvec3> sums(mesh.vertexCount(), glm::dvec3(0));
  std::vector<glm::dvec3> sumsOfSheets(sheets.ofVertices.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < mesh.triangleCount(); ++i) {
    if (sheets.isTwoSided[i])
      addTriangle(mesh, mesh.corners(i), sheets.ofVertices, sumsOfSheets);
    else
      addTriangle(mesh, mesh.corners(i), places, sums);
  }
  std::vector<float> normals(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < places.size(); ++vertex) {
    glm::dvec3 sum = sums[places[vertex]];
    if (!sumsOfSheets.empty()) sum += sumsOfSheets[sheets.ofVertices[vertex]];
    const double length = glm::length(sum);
    for (int i = 0; i < 3 && length > 0; ++i)
      normals[vertex * 3 + i] = static_cast<float>(sum[i] / length);
  }
  return normals;
}

}  // namespace warpjet
