// Computes operations on known operands.
#pragma once

#include <optional>
#include <span>

#include "source/codes.hpp"

namespace warpjet::source {

// Returns nullopt if there is no value, or if it is left to the shader compiler. Floats are
// float32; ints start at -2^31 and uints at 0; the caller wraps the result.
std::optional<double> fold(Code code, std::span<const double> x);

// Includes functions whose accuracy is left open by shaders.
std::optional<double> foldFunction(Code code, std::span<const double> x);

}  // namespace warpjet::source
