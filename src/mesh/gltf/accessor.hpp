// Reads the numbers of an accessor of any type, stride and sparseness (glTF 2.0, sections 3.6.2
// and 5.1) as plain numbers. Every read is checked against the available bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// Returns the number of elements, without reading them. Throws if bytes are missing, or if an
// accessor without bytes declares more than 2^22 elements, so that nobody allocates memory for a
// count that is only declared.
std::size_t countOf(const Gltf& gltf, int accessor);

// Appends `width` floats per element; shorter elements are padded with ones (a color without
// alpha). Supports floats and integers of 8 and 16 bits, normalized or not (KHR_mesh_quantization),
// in vectors of `minWidth` to `width` numbers. Throws a FileProblem.
void appendFloats(const Gltf& gltf, int accessor, int minWidth, int width,
                  std::vector<float>& numbers);

// Appends 16 floats per matrix, column by column. Throws a FileProblem.
void appendMatrices(const Gltf& gltf, int accessor, std::vector<float>& numbers);

// Returns indices: unsigned integers of 8, 16 or 32 bits. Throws a FileProblem.
std::vector<std::uint32_t> indicesOf(const Gltf& gltf, int accessor);

}  // namespace warpjet
