// Curved PN triangles: a smooth surface through the vertices of a mesh, at right angles to their
// normals. Vlachos, Peters, Boyd and Mitchell, "Curved PN Triangles", I3D 2001, section 3.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "detail/base_mesh.hpp"

namespace warpjet {

class PnTriangles {
 public:
  // `normals` is the index of the attribute that contains the normals.
  PnTriangles(BaseMesh mesh, std::size_t normals);

  std::size_t normals() const { return normals_; }
  // Replaces the values of the vertices.
  void setAttributes(const std::vector<Attribute>& attributes);

  // On sides, where one weight is 0, equal weights give the same bits on both sides of a seam.
  glm::vec3 position(std::size_t triangle, const Weights& weights) const;
  // Returns a vector of length 1; zero only if normals cancel out.
  glm::vec3 normal(std::size_t triangle, const Weights& weights) const;

 private:
  // The control points of an edge between its ends, in the order of its sides' ends.
  using Curve = std::array<glm::vec3, 2>;

  // A point of a side, by the weights of the side's ends.
  struct SidePoint {
    std::uint32_t sideIndex;  // in the mesh
    float start, end;
  };

  void fit();
  void fitCurves();
  glm::vec3 place(std::uint32_t vertex) const;
  glm::vec3 normalAt(std::uint32_t vertex) const;
  SidePoint onSide(std::size_t triangle, int side, const Weights& weights) const;

  BaseMesh mesh_;
  std::size_t normals_;
  std::vector<Curve> curves_;             // by edge
  std::vector<glm::vec3> middleNormals_;  // by side
  std::vector<glm::vec3> centers_;        // by triangle: its inner control point
};

}  // namespace warpjet
