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
  // Throws a FileProblem if this number of triangles exceeds the limit.
  void reserve(std::uint64_t count);

  // The numbers may be NaN or infinite.
  void add(const glm::vec3& normal, const std::array<glm::vec3, 3>& corners);

  // Throws a FileProblem if there are no triangles.
  Mesh mesh(std::vector<std::string>& warnings);

 private:
  Mesh mesh_;
  bool hasOddNormals_ = false, hasOddPositions_ = false;
};

}  // namespace warpjet
