// Lists the triangles and sides of a base mesh for compute passes.
#pragma once

#include <cstdint>
#include <vector>

#include "detail/base_mesh.hpp"

namespace warpjet {

// Returns six words for each triangle: its three corners, then for side i twice its index, plus one
// if the side starts at corner i. Then three words for each side: its two ends, and its edge.
std::vector<std::uint32_t> topologyOf(const BaseMesh& base);

}  // namespace warpjet
