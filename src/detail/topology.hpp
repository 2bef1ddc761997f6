// A base mesh as numbers for compute passes.
#pragma once

#include <cstdint>
#include <vector>

#include "detail/base_mesh.hpp"

namespace warpjet {

// Six numbers for each triangle: its corners, then its sides, each times two, plus one if it starts
// at its corner. Then three for each side: its ends and its edge.
std::vector<std::uint32_t> topologyOf(const BaseMesh& base);

}  // namespace warpjet
