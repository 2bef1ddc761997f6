// How far a warped surface leaves the straight pieces that stand for it, found by samples.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/subdivide.hpp"

namespace warpjet {

// A triangle, or an edge whose third corner is the first one again.
struct Piece {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t samples;

  bool isEdge() const { return corners[2] == corners[0]; }
};

struct Deviation {
  float distance = 0;  // the largest of a warped sample from the piece between warped corners
  float angle = 0;     // radians, the largest between warped and interpolated normals
};

// All of the warped vertices of the mesh are in `warped`. Samples that are NaN or infinite do not
// count, and no more than the rounding of floats is not a distance.
std::vector<Deviation> measure(const Mesh& mesh, const Moved& warped, std::span<const Piece> pieces,
                               const WarpFunction& warp);

// The warp of these vertices; what it leaves out is NaN.
Moved evaluate(const Mesh& vertices, const WarpFunction& warp);

}  // namespace warpjet
