#include "mesh/surface/normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "mesh/surface/blend.hpp"
#include "mesh/surface/pairs.hpp"
#include "mesh/surface/sheets.hpp"
#include "mesh/surface/weld.hpp"

namespace warpjet {

namespace {

// Returns the number of each vertex's position.
std::vector<std::uint32_t> weldVertices(const std::vector<float>& positions) {
  Welder welder;
  std::vector<std::uint32_t> welded;
  for (std::size_t i = 0; i < positions.size(); i += 3)
    welded.push_back(welder.weld({positions[i], positions[i + 1], positions[i + 2]}));
  return welded;
}

// Returns a position in double, where not even the squares of the largest floats overflow.
glm::dvec3 positionAt(const Mesh& mesh, std::uint32_t vertex) {
  const float* p = &mesh.positions[std::size_t{vertex} * 3];
  return {p[0], p[1], p[2]};
}

double angleBetween(const glm::dvec3& u, const glm::dvec3& v) {
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

class Normals {
 public:
  explicit Normals(const Mesh& mesh)
      : positionIds_(weldVertices(mesh.positions)),
        sheets_(findSheets(mesh, positionIds_)),
        sums_(mesh.vertexCount(), glm::dvec3(0)),
        sumsOfSheets_(sheets_.count, glm::dvec3(0)),
        sheetOfVertex_(sheets_.isOnBothSides.size(), none) {
    for (std::size_t i = 0; i < mesh.triangleCount(); ++i) addTriangle(mesh, i);
  }

  void write(std::vector<float>& normals, std::size_t vertex) const {
    const bool isOfSheet = !sheetOfVertex_.empty() && sheetOfVertex_[vertex] != none;
    const glm::dvec3& sum =
        isOfSheet ? sumsOfSheets_[sheetOfVertex_[vertex]] : sums_[positionIds_[vertex]];
    const double length = glm::length(sum);
    for (int i = 0; i < 3; ++i)
      normals[vertex * 3 + i] = length > 0 ? static_cast<float>(sum[i] / length) : 0;
  }

  // Gives each side its own vertices: a vertex used by both sides stays with the first side; the
  // other side gets a copy, appended to the existing vertices.
  void separateSides(Mesh& mesh, const std::vector<bool>& hasNormal) {
    Pairs copies;
    for (std::size_t i = 0; i < sheets_.sheetOfCorner.size() && !mesh.indices.empty(); ++i) {
      const std::uint32_t vertex = mesh.indices[i], sheet = sheets_.sheetOfCorner[i];
      if (sheet == none || hasNormal[vertex] || !sheets_.isOnBothSides[vertex] ||
          sheet == sheetOfVertex_[vertex])
        continue;
      const auto next = static_cast<std::uint32_t>(mesh.vertexCount());
      mesh.indices[i] = copies.findOrAdd(vertex, sheet, next);
      if (mesh.indices[i] != next) continue;
      appendBlend(mesh, mesh, {{vertex, vertex, vertex}, {1, 0, 0}});
      sheetOfVertex_.push_back(sheet);
    }
  }

 private:
  void addTriangle(const Mesh& mesh, std::size_t triangle) {
    const std::array<std::uint32_t, 3> corners = mesh.corners(triangle);
    std::array<glm::dvec3, 3> p;
    for (int i = 0; i < 3; ++i) p[i] = positionAt(mesh, corners[i]);
    // Its length is twice the area.
    const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t sheet =
          sheets_.sheetOfCorner.empty() ? none : sheets_.sheetOfCorner[3 * triangle + i];
      if (sheet != none && sheetOfVertex_[corners[i]] == none) sheetOfVertex_[corners[i]] = sheet;
      if (normal == glm::dvec3(0)) continue;
      const double angle = angleBetween(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
      (sheet == none ? sums_[positionIds_[corners[i]]] : sumsOfSheets_[sheet]) += angle * normal;
    }
  }

  std::vector<std::uint32_t> positionIds_;
  Sheets sheets_;
  std::vector<glm::dvec3> sums_, sumsOfSheets_;
  std::vector<std::uint32_t> sheetOfVertex_;  // the sheet of each vertex, if any
};

}  // namespace

std::vector<float> computeNormals(const Mesh& mesh) {
  const Normals computed(mesh);
  std::vector<float> normals(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    computed.write(normals, vertex);
  return normals;
}

void addMissingNormals(Mesh& mesh, const std::vector<bool>& hasNormal) {
  mesh.normals.resize(mesh.positions.size());
  if (std::find(hasNormal.begin(), hasNormal.end(), false) == hasNormal.end()) return;
  Normals computed(mesh);
  computed.separateSides(mesh, hasNormal);
  for (std::size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    if (vertex >= hasNormal.size() || !hasNormal[vertex]) computed.write(mesh.normals, vertex);
}

}  // namespace warpjet
