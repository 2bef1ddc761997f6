#include "mesh/stl/facets.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "mesh/files.hpp"
#include "mesh/messages.hpp"

namespace warpjet {

namespace {

constexpr std::size_t bytesPerTriangle = 18 * sizeof(float);

bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Normalizes a vector; a zero vector stays zero. Uses double, in which the square of a float
// doesn't overflow.
glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

void Facets::reserve(std::uint64_t count) {
  if (count > maxMeshBytes / bytesPerTriangle)
    throw FileProblem("the model has " + groupDigits(count) +
                      " triangles; the maximum for an .stl is " +
                      groupDigits(maxMeshBytes / bytesPerTriangle) +
                      "; export it as .glb or with fewer triangles.");
  mesh_.positions.reserve(static_cast<std::size_t>(count) * 9);
  mesh_.normals.reserve(static_cast<std::size_t>(count) * 9);
}

void Facets::add(const glm::vec3& normal, const std::array<glm::vec3, 3>& corners) {
  if (!std::all_of(corners.begin(), corners.end(), isFinite)) {
    hasInvalidPositions_ = true;
    return;
  }
  glm::dvec3 direction(0);
  if (isFinite(normal))
    direction = unit(glm::dvec3(normal));
  else
    hasInvalidNormals_ = true;
  const auto [a, b, c] = std::array<glm::dvec3, 3>{corners[0], corners[1], corners[2]};
  if (direction == glm::dvec3(0)) direction = unit(glm::cross(b - a, c - a));
  for (const glm::vec3& corner : corners)
    for (int i = 0; i < 3; ++i) {
      mesh_.positions.push_back(corner[i]);
      mesh_.normals.push_back(static_cast<float>(direction[i]));
    }
}

Mesh Facets::takeMesh(std::vector<std::string>& warnings) {
  if (mesh_.positions.empty())
    throw FileProblem(
        "there is nothing to draw: the .stl has no triangles; export the model again.");
  if (hasInvalidNormals_)
    warnings.push_back(
        "The .stl has invalid normals, which were replaced by normals of the triangles.");
  if (hasInvalidPositions_) warnings.push_back("Triangles with invalid positions are left out.");
  return std::move(mesh_);
}

}  // namespace warpjet
