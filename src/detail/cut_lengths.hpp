// Decides into how many pieces the edges of a mesh are cut before it is measured.
#pragma once

#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/phase_samples.hpp"

namespace warpjet {

// Returns for each edge the number of pieces, not rounded, such that none is longer than
// `maxLength`, no phase changes along it by more than its step, and fronts show at samples. The
// numbers are smaller if there would be too many triangles.
std::vector<float> cutLengths(const BaseMesh& base, const PhaseSamples& samples, float maxLength);

}  // namespace warpjet
