// Computes operations on known operands.
#pragma once

#include <optional>
#include <span>

#include "source/codes.hpp"

namespace warpjet::source {

// Computes an operation. Returns nullopt if there is no value, or if it is left to the shader
// compiler. Floats are float32, ints are from -2^31 to 2^31 - 1, and uints from 0 to 2^32 - 1. The
// caller wraps the result.
std::optional<double> fold(Code code, std::span<const double> x);

// Like `fold`, but also computes functions for which shader languages don't specify the accuracy.
std::optional<double> foldFunction(Code code, std::span<const double> x);

}  // namespace warpjet::source
