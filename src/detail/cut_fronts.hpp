// Decides where a mesh is cut such that its samples show fronts (see eval/front.hpp).
#pragma once

#include <span>
#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/phase_samples.hpp"

namespace warpjet {

// `Yes` cuts at kinks and cusps that stay where they are, too, so that the division needs fewer
// pieces there.
enum class CutCreases : bool { No, Yes };

// Marks the edges that must be halved. Within a triangle, the number of a front is estimated by
// quadratics through its samples, so that a peak is found between them, too. Edges that are much
// shorter than `maxLength` are not halved: 128 times, or 8 times at kinks, which need pieces, too.
std::vector<bool> edgesToHalve(const BaseMesh& base, const PhaseSamples& samples, float maxLength,
                               CutCreases cutCreases);

}  // namespace warpjet
