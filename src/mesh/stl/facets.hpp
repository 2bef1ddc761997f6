// Collects the triangles of an STL file to a mesh.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace warpjet {

class Facets {
 public:
  // Reserves memory. Throws a FileProblem if this number of triangles exceeds the limit.
  void reserve(std::uint64_t count);

  // Adds a triangle. Its numbers may be NaN or infinite.
  void add(const glm::vec3& normal, const std::array<glm::vec3, 3>& corners);

  // Returns the mesh. Throws a FileProblem if there are no triangles.
  Mesh takeMesh(std::vector<std::string>& warnings);

 private:
  Mesh mesh_;
  bool hasInvalidNormals_ = false, hasInvalidPositions_ = false;
};

}  // namespace warpjet
