// The value of an operation whose operands are known.
#pragma once

#include <optional>
#include <span>

#include "glsl/codes.hpp"

namespace warpjet::glsl {

// Nothing where it has none, or is left to the compiler. Floats are float32; an int is from -2^31,
// a uint from 0, and whoever asked wraps the result.
std::optional<double> fold(Code code, std::span<const double> x);

// The same of all functions, whose last bits shaders leave open.
std::optional<double> foldFunction(Code code, std::span<const double> x);

}  // namespace warpjet::glsl
