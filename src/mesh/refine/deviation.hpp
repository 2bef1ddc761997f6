// Measures by samples how far a warped surface deviates from the straight pieces that approximate
// it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/subdivide.hpp"

namespace warpjet {

// The number of vertices per call of the warp: large enough to amortize the call, small enough for
// caches.
constexpr std::size_t batchSize = 1 << 14;

using Weights = std::array<float, 3>;

// A triangle, or an edge whose third corner equals the first.
struct Piece {
  std::array<std::uint32_t, 3> corners;
  std::array<std::uint32_t, 3> sides;  // the first is between the first two corners, and so on
  std::uint32_t samples;
  std::uint32_t firstSample = 0;  // samples before this one were measured in an earlier call

  bool isEdge() const { return corners[2] == corners[0]; }
};

// Distances in model units and angles in radians.
struct SurfaceError {
  float distance = 0, angle = 0;

  void raise(const SurfaceError& other);
};

struct Deviation {
  // The largest deviation of warped samples and normals from the straight piece between the
  // corners.
  SurfaceError max;
  // The largest deviation from a parabola through the midpoints. It estimates how much larger the
  // deviation may be between samples.
  SurfaceError residual;
  Weights maxAngleSample;  // the sample with the largest angle
  float unresolved = 0;    // the largest distance that is too small to tell from rounding errors
  bool isDefined = true;   // true if all samples were finite
};

// Measures pieces. `warped` has the warped vertices of the mesh, and `middles` the warped midpoints
// of sides, which edges write and triangles read, so edges must be measured first. Samples that are
// NaN or infinite are ignored, and distances below the resolution of floats don't count.
std::vector<Deviation> measure(const Mesh& mesh, const Moved& warped, Moved& middles,
                               std::span<const Piece> pieces, const WarpFunction& warp);

// Warps these vertices; positions that the warp omits are NaN. With `hasNormals`, there is one
// normal per vertex, whatever the warp returns; otherwise there are none.
Moved applyWarp(const Mesh& vertices, const WarpFunction& warp, bool hasNormals);
// Gives the result of a warp the length for this number of vertices, in the same way as applyWarp.
void fit(Moved& moved, std::size_t vertices, bool hasNormals);

}  // namespace warpjet
