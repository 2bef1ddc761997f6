// Formats numbers: takes a double, returns the text of a float.
#pragma once

#include <string>

namespace warpjet {

// Returns the fewest digits that read back as the same float32, which is what a shader stores.
// There is always a point or an exponent, so that the number is a float in every dialect: 0.15,
// 2.0, 1e-7, 3.1415927. `value` must be in the range of float32.
std::string literal(double value);

}  // namespace warpjet
