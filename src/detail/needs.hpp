// Decides into how many pieces each edge is divided, such that the drawn triangles are within a
// tolerance, in pixels, of the warped surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "detail/flips.hpp"
#include "detail/triangle_needs.hpp"

namespace warpjet {

// The numbers of pieces of edges. An edge keeps more pieces than the surface needs until it needs
// far fewer, so that the mesh rarely changes.
class Needs {
 public:
  // Measures the mesh, and chooses the numbers of pieces. Samples that are not finite ask for none.
  void update(const WarpedMesh& mesh, std::span<const ScreenView> views, float tolerance);
  // Divides all needs by a number, and chooses fewer pieces.
  void lower(float divisor);

  std::span<const std::uint32_t> pieces() const { return pieces_; }
  // Tests whether a number of pieces differs from that before the last update.
  bool areChanged() const { return pieces_ != formerPieces_; }
  // The squared sides of each triangle in the metric of its bend, in which a side of length 1 errs
  // by a pixel; zeros for triangles that are invisible, or close to all of their samples.
  std::span<const SquaredSides> bentSides() const { return bentSides_; }
  // The square of the number of pieces, not rounded, that would suffice if all sides of the given
  // mesh had the same number.
  float squaredUniform() const { return squaredUniform_; }

  // Tests whether these pieces will be within the tolerance if each need grows by as much as it
  // changed in the last update. Returns false if that was the first update, or if it revealed more
  // than a few edges.
  bool piecesStayExact() const;
  // Tests the same for a number of pieces that all sides of the given mesh have.
  bool uniformStaysExact(std::uint32_t pieces) const;

 private:
  void choosePieces();

  float squaredUniform_ = 0, uniformChange_ = 0;
  std::vector<SquaredSides> bentSides_;
  // The squares of the numbers of pieces, by edge: now, and in the update before.
  std::vector<float> squares_, formerSquares_;
  std::vector<std::uint32_t> pieces_, formerPieces_;  // by edge
};

// Returns the smallest of `pieceCounts` that is not below `need`; the largest one if all are.
std::uint32_t roundUp(float need);

}  // namespace warpjet
