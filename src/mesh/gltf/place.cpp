#include "mesh/gltf/place.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "mesh/gltf/triangles.hpp"

namespace warpjet {

namespace {

glm::dvec3 at(const std::vector<float>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

void set(std::vector<float>& numbers, std::size_t first, const glm::dvec3& value) {
  for (int i = 0; i < 3; ++i) numbers[first + i] = static_cast<float>(value[i]);
}

glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

// Returns the inverse transpose up to a positive factor: the cofactor matrix, which has the columns
// m2 x m3, m3 x m1, m1 x m2, times the determinant's sign. It needs no division and exists for flat
// transforms, too.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
  const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                             glm::cross(m[0], m[1]));
  return glm::determinant(m) < 0 ? -cofactors : cofactors;
}

void move(Mesh& mesh, std::size_t vertex, const glm::dmat4& toWorld, const glm::dmat3& forNormals) {
  const std::size_t i = vertex * 3, k = vertex * 4;
  set(mesh.positions, i, glm::dvec3(toWorld * glm::dvec4(at(mesh.positions, i), 1)));
  set(mesh.normals, i, unit(forNormals * at(mesh.normals, i)));
  if (!mesh.tangents.empty())
    set(mesh.tangents, k, unit(glm::dmat3(toWorld) * at(mesh.tangents, k)));
}

void setHandedness(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, bool isMirrored) {
  for (std::size_t i = firstVertex * 4 + 3; i < mesh.tangents.size(); i += 4)
    mesh.tangents[i] = (mesh.tangents[i] < 0) == isMirrored ? 1.0f : -1.0f;
  if (isMirrored) reverseWinding(mesh.indices, firstIndex);
}

}  // namespace

void place(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const glm::dmat4& toWorld) {
  const glm::dmat3 m(toWorld);
  setHandedness(mesh, firstVertex, firstIndex, glm::determinant(m) < 0);
  if (toWorld == glm::dmat4(1)) return;
  const glm::dmat3 forNormals = normalMatrix(m);
  for (std::size_t i = firstVertex; i < mesh.vertexCount(); ++i) move(mesh, i, toWorld, forNormals);
}

void pose(Mesh& mesh, std::size_t firstVertex, std::size_t firstIndex, const Skin& skin,
          const std::vector<float>& joints, const std::vector<float>& weights) {
  setHandedness(mesh, firstVertex, firstIndex, skin.isMirrored);
  const std::size_t vertices = mesh.vertexCount() - firstVertex;
  for (std::size_t i = 0; i < vertices; ++i) {
    const std::size_t width = joints.size() / vertices;
    const glm::dmat4 toWorld = blendOf(skin, std::span(joints).subspan(i * width, width),
                                       std::span(weights).subspan(i * width, width));
    move(mesh, firstVertex + i, toWorld, normalMatrix(glm::dmat3(toWorld)));
  }
}

}  // namespace warpjet
