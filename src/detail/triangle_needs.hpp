// Measures how finely triangles must be divided, four at once.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "detail/base_mesh.hpp"
#include "detail/four_triangles.hpp"
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
  // The arguments of fronts at the same samples.
  const PhaseSamples& phases;
  // The triangles before all cuts, whose vertices come first; empty if there are no patches.
  std::span<const Corners> given;
  // The triangles whose samples are warped. The others ask for no pieces.
  std::span<const std::uint32_t> triangles;
};

// Errors shrink with the square of the number of pieces, so the squares of these numbers are
// compared.
struct TriangleNeeds {
  std::array<Lanes, 3> squaredSides{0.0f, 0.0f, 0.0f};  // by side
  // If all sides of the given triangles had the same number.
  Lanes squaredUniform = 0.0f;
  // The squared sides in the metric of the bend: see `Needs::bentSides`.
  std::array<Lanes, 3> bentSides{0.0f, 0.0f, 0.0f};
};

TriangleNeeds needsOf(const WarpedMesh& mesh, const FourTriangles& triangles,
                      std::span<const ScreenView> views, float tolerance);

}  // namespace warpjet
