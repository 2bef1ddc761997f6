// How far a warped surface leaves the straight pieces that stand for it, found by samples.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/subdivide.hpp"

namespace warpjet {

// So many vertices go to the warp at once: enough that the call costs nothing, few enough for
// caches.
constexpr std::size_t batchSize = 1 << 14;

using Weights = std::array<float, 3>;

// A triangle, or an edge whose third corner is the first one again.
struct Piece {
  std::array<std::uint32_t, 3> corners;
  std::array<std::uint32_t, 3> sides;  // the first between the first two corners, and so on
  std::uint32_t samples;
  std::uint32_t firstSample = 0;  // where those before are known

  bool isEdge() const { return corners[2] == corners[0]; }
};

// Of distances in model units and angles in radians.
struct Off {
  float distance = 0, angle = 0;

  void raise(const Off& other);
};

struct Deviation {
  Off most;       // of warped samples and normals from those interpolated between warped corners
  Off surprise;   // the same from a parabola through the middles too: what samples may have missed
  Weights where;  // the sample of the largest angle
  float unresolved = 0;   // the largest distance that is no more than the rounding of floats
  bool isDefined = true;  // whether all samples were finite
};

// All of the warped vertices of the mesh are in `warped`. Those in the middle of sides are in
// `middles`: edges write theirs, before triangles read them. Samples that are NaN or infinite do
// not count, and what no float can resolve is no distance.
std::vector<Deviation> measure(const Mesh& mesh, const Moved& warped, Moved& middles,
                               std::span<const Piece> pieces, const WarpFunction& warp);

// The warp of these vertices; positions that it leaves out are NaN. With normals there are as many
// as wanted, whatever it gives, and without none.
Moved warpedBy(const Mesh& vertices, const WarpFunction& warp, bool hasNormals);
void fit(Moved& moved, std::size_t vertices, bool hasNormals);

}  // namespace warpjet
