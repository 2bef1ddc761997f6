// A mesh whose edges can be split without a crack: triangles know their sides, and sides know the
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

// Two positions, by their numbers. Whether it is split is decided here, once for all its sides.
struct Edge {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t middle = none;  // once it is split
  std::uint32_t uses = 0;       // by triangles, now
};

// Two vertices, in the order of their edge's ends. Triangles on both sides of a seam (split
// normals, UVs or colours) have different sides on one edge.
struct Side {
  std::array<std::uint32_t, 2> ends;
  std::uint32_t edge;
  std::uint32_t middle = none;                      // once it is split
  std::array<std::uint32_t, 2> halves{none, none};  // then, at each end
};

struct Triangle {
  std::array<std::uint32_t, 3> corners;
  std::array<std::uint32_t, 3> sides;  // the first between the first two corners, and so on
  std::uint32_t origin;                // the number of the one that came
  int longest;                         // of the sides
  bool isSliver;
  // How far the warped surface and its normals are off inside, once that is measured.
  bool isMeasured = false;
  float distance = 0, angle = 0;
};

class Surface {
 public:
  explicit Surface(Mesh mesh);

  // Its indices are as they came; see `takeMesh`.
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

  // Gives each of these edges (and all its sides) a vertex in the middle. Then `divide` must
  // follow.
  void addMiddles(std::span<const std::uint32_t> edges);

  // Replaces each triangle that has split sides: 1, 2, 3 of them make 2, 3, 4 triangles. Where
  // there is a choice, the diagonal that is shorter between `positions` is taken, 3 numbers a
  // vertex.
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
  bool isSlit(const Triangle& triangle) const;
  std::uint32_t halfOf(std::uint32_t side, std::uint32_t end) const;
  void split(std::uint32_t side);
  void add(const Three& corners, const Three& sides, std::uint32_t origin);
  void divide(const Triangle& triangle, const std::vector<float>& positions);

  Mesh mesh_;
  std::vector<std::uint32_t> ends_;  // of new vertices, two each
  Welder welder_;
  std::vector<std::uint32_t> welded_;  // by vertex, the number of its position
  Pairs edgesByEnds_, sidesByEnds_;
  std::vector<Side> sides_;
  std::vector<Edge> edges_;
  std::vector<Triangle> triangles_;
};

}  // namespace warpjet
