// How a number is written: a double enters, the text of a float leaves.
#pragma once

#include <string>

namespace warpjet {

// The fewest digits that read back as the same float32, which is what a shader holds, always with a
// point or an exponent, so that it is a float in every dialect: 0.15, 2.0, 1e-7, 3.1415927.
// `value` must be in float32's range.
std::string literal(double value);

}  // namespace warpjet
