// Finds triangles within which the slope of the warped surface jumps.
#pragma once

#include "detail/base_mesh.hpp"
#include "detail/four_triangles.hpp"
#include "detail/phase_samples.hpp"

namespace warpjet {

// Tests whether the number of a kink passes its limit within triangles. A kink along a side does
// not count.
Mask areKinked(const BaseMesh& base, const FourTriangles& triangles, const PhaseSamples& phases);

}  // namespace warpjet
