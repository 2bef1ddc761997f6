// Signatures of built-in functions, which may be generic in the size of vectors and matrices.
//
// A signature consists of a letter for the result and one per parameter; a parameter after `>` is
// an out parameter.
//   F i u b   float, int, uint, bool
//   G I U B   a scalar or vector of float, int, uint, bool
//   V W X Y   a vector of float, int, uint, bool
//             (all of G I U B V W X Y in one signature have the same size)
//   2 3 4     vec2, vec3, vec4
//   k n m     ivec2, ivec4, uvec4
//   M Q T     any matrix, a square matrix, the transpose of M
//   O         the matrix of an outer product, whose operands may differ in size
//   S         sampler2D
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "source/types.hpp"

namespace warpjet::source {

// Returns the type of the result, or nullopt if the operands don't match.
std::optional<Type> matchSignature(std::string_view signature, std::span<const Type> operands);

// Returns true if this parameter is an out parameter.
bool isOutParameter(std::string_view signature, std::size_t parameter);

}  // namespace warpjet::source
