// Decides into how many pieces each edge is divided, such that the drawn triangles are within a
// tolerance, in pixels, of the warped surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/flips.hpp"
#include "detail/interpolation.hpp"
#include "detail/phase_samples.hpp"
#include "detail/triangles_on_screen.hpp"

namespace warpjet {

// A mesh whose samples are warped.
struct WarpedMesh {
  const BaseMesh& base;
  // One patch for each triangle; empty if the mesh is the given one.
  std::span<const Patch> patches;
  // Three numbers for each sample of the mesh.
  std::span<const float> warped;
  // The numbers of kinks at the same samples.
  const PhaseSamples& phases;
  // The triangles before all cuts, whose vertices come first; empty if there are no patches.
  std::span<const Corners> given;
  // The triangles whose samples are warped. The others ask for no pieces.
  std::span<const std::uint32_t> triangles;
};

// The numbers of pieces of edges. An edge keeps more pieces than the surface needs until it needs
// far fewer, so that the mesh rarely changes.
class Needs {
 public:
  // Returns true if a number of pieces changed. Samples that are not finite ask for no
  // pieces.
  bool update(const WarpedMesh& mesh, std::span<const ScreenView> views, float tolerance);

  std::span<const std::uint32_t> pieces() const { return pieces_; }
  // The squared sides of each triangle in the metric of its bend, in which a side of length 1 errs
  // by a pixel; zeros for triangles that are invisible, or close to all of their samples.
  std::span<const SquaredSides> squaredSides() const { return squaredSides_; }
  // The number of pieces, not rounded, that would suffice if all sides of the given mesh had the
  // same number.
  float uniformNeed() const { return uniformNeed_; }

 private:
  float uniformNeed_ = 0;
  std::vector<SquaredSides> squaredSides_;
  std::vector<float> needs_;           // by edge: the square of the number of pieces
  std::vector<std::uint32_t> pieces_;  // by edge
};

// Returns the smallest of `pieceCounts` that is not below `need`; the largest one if all are.
std::uint32_t roundUp(float need);

}  // namespace warpjet
