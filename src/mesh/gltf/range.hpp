// Enforces the ranges that a Mesh guarantees on the numbers of a file, from an index in the array
// on; warns if that makes a visible difference. NaN and infinities remain and are rejected later.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// Clamps colors to the range from 0 to 1.
void clampColors(Gltf& gltf, std::vector<float>& colors, std::size_t first);

// Normalizes the first three of `stride` numbers. Unit vectors keep their bits, and zero stays
// zero. The first function returns whether the difference is visible; the second one warns if it
// is. `name` is "Normals", for example.
bool makeUnit(std::vector<float>& vectors, std::size_t first, std::size_t stride);
void makeUnit(Gltf& gltf, std::vector<float>& vectors, std::size_t first, std::size_t stride,
              const std::string& name);

}  // namespace warpjet
