// The numbers of an accessor, of whatever type, stride and sparseness (glTF 2.0, sections 3.6.2 and
// 5.1), as plain numbers. Every read is checked against the bytes that are there.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/gltf/gltf.hpp"

namespace warpjet {

// How many elements it has, without reading them. Refused where its bytes are not there, or beyond
// 2^22 if it has no bytes of its own, so that nobody makes room for a count that only is said.
std::size_t countOf(const Gltf& gltf, int accessor);

// Appends `width` floats for each element; elements of fewer numbers are followed by ones (a colour
// without alpha). Floats and integers of 8 and 16 bits, normalized or not (KHR_mesh_quantization),
// in vectors of `least` to `width` numbers. Throws a FileProblem.
void appendFloats(const Gltf& gltf, int accessor, int least, int width,
                  std::vector<float>& numbers);

// Appends 16 floats for each matrix, by columns. Throws a FileProblem.
void appendMatrices(const Gltf& gltf, int accessor, std::vector<float>& numbers);

// Unsigned integers of 8, 16 and 32 bits. Throws a FileProblem.
std::vector<std::uint32_t> indicesOf(const Gltf& gltf, int accessor);

}  // namespace warpjet
