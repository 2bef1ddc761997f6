// Finds the vertices of a mesh that are at the same place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace warpjet {

// Returns numbers that are equal for vertices at the same place, or so close to each other that
// only rounding can tell them apart, as at the seam of a sphere whose angles end at 2 pi:
// sin(2 pi) is not 0. `positions` has three numbers for each vertex.
std::vector<std::uint32_t> placesOf(std::span<const float> positions);

}  // namespace warpjet
