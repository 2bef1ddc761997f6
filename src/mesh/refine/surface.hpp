// A mesh whose edges can be split without cracks: triangles refer to their sides, and sides to the
// edge that they share with all others between the same two positions.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/refine/subdivide.hpp"
#include "mesh/surface/pairs.hpp"
#include "mesh/surface/weld.hpp"

namespace warpjet {

// An edge between two positions, given by number. All its sides are split together.
struct Edge {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t middle = none;  // set when it is split
  std::uint32_t uses = 0;       // number of triangles that currently use it
};

// Two vertices, in the order of their edge's ends. Triangles on both sides of a seam (split
// normals, UVs or colors) have different sides of one edge.
struct Side {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t edge;
  std::uint32_t middle = none;                      // set when it is split
  std::array<std::uint32_t, 2> halves{none, none};  // likewise, one per end
};

struct Triangle {
  std::array<std::uint32_t, 3> corners;
  std::array<std::uint32_t, 3> sides;  // the first is between the first two corners, and so on
  std::uint32_t origin;                // number of the original triangle
  int longest;                         // of its sides
  bool isSliver;
  // The deviation of the warped surface and its normals inside, once it is measured.
  bool isMeasured = false;
  float distance = 0, angle = 0;
};

class Surface {
 public:
  explicit Surface(Mesh mesh);

  // The indices are the original ones; see `takeMesh`.
  const Mesh& mesh() const { return mesh_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<Side>& sides() const { return sides_; }
  const std::vector<Edge>& edges() const { return edges_; }

  std::uint32_t edgeNumber(const Triangle& triangle, int side) const {
    return sides_[triangle.sides[side]].edge;
  }
  double areaOf(const std::array<std::uint32_t, 3>& corners) const;
  const Position& endOf(const Edge& edge, int end) const {
    return welder_.position(edge.ends[end]);
  }
  Position middleOf(const Edge& edge) const;

  // Adds a vertex in the middle of each side of these edges. Call `divide` afterwards.
  void addMiddles(std::span<const std::uint32_t> edges);

  // Replaces each triangle that has split sides: with 1, 2 or 3 split sides it becomes 2, 3 or 4
  // triangles. If there is a choice, it uses the diagonal that is shorter in `positions`, 3 numbers
  // per vertex.
  void divide(const std::vector<float>& positions);

  void setMeasured(std::size_t triangle, float distance, float angle) {
    triangles_[triangle].isMeasured = true;
    triangles_[triangle].distance = distance;
    triangles_[triangle].angle = angle;
  }

  Origins origins() const;
  Mesh takeMesh() &&;

 private:
  using Three = std::array<std::uint32_t, 3>;

  std::uint32_t findSide(std::uint32_t a, std::uint32_t b);
  bool isDegenerate(const Triangle& triangle) const;
  std::uint32_t halfOf(std::uint32_t side, std::uint32_t end) const;
  void split(std::uint32_t side);
  void add(const Three& corners, const Three& sides, std::uint32_t origin);
  void divide(const Triangle& triangle, const std::vector<float>& positions);

  Mesh mesh_;
  std::vector<std::uint32_t> ends_;  // of new vertices, two each
  Welder welder_;
  std::vector<std::uint32_t> welded_;  // by vertex: the number of its position
  Pairs edgesByEnds_, sidesByEnds_;
  std::vector<Side> sides_;
  std::vector<Edge> edges_;
  std::vector<Triangle> triangles_;
};

}  // namespace warpjet
