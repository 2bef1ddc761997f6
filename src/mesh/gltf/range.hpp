// The ranges that a Mesh promises, put upon the numbers of a file: from a place in the array on,
// and with a warning where that changes what can be seen. NaN and infinities stay, to be refused.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// To 0 to 1.
void clampColors(Gltf& gltf, std::vector<float>& colors, std::size_t first);

// The first three of `stride` numbers, to a length of 1. What is so already keeps its bits, and
// zero stays zero. Answers whether that can be seen; `name` is "Normals", for example.
bool makeUnit(std::vector<float>& vectors, std::size_t first, std::size_t stride);
void makeUnit(Gltf& gltf, std::vector<float>& vectors, std::size_t first, std::size_t stride,
              const std::string& name);

}  // namespace warpjet
