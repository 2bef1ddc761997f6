// Signatures of built-in functions, which may be generic in the size of vectors and matrices.
//
// A signature consists of a letter for the result and one per parameter; a parameter after `>` is
// an out parameter.
//   G float or vec2 to vec4, all of the same size; F float; I int or ivec likewise, i int; U, u
//   uint; B bool and bvec, b bool; V vec2 to vec4; W ivec; X uvec; Y bvec; 2 3 4 vec2 …; M any
//   matrix; Q a square matrix; S sampler2D; k ivec2; n ivec4; m uvec4; T the transpose of M; O the
//   matrix of an outer product, whose operands may differ in size
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
