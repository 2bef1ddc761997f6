// Parts of error messages.
#pragma once

#include <string>
#include <string_view>

#include "graph/shape.hpp"
#include "module/syntax.hpp"

namespace warpjet {

// Returns "a single number", "a vec3", "a mat3", "a matrix of 2 columns and 3 rows", and so on.
std::string shapeName(Shape shape);

// Describes a number of arguments: returns "no arguments", "1 argument", "3 arguments", and so on.
std::string argumentCount(int count);

inline constexpr std::string_view notFinite =
    "the result of these constants is not a finite float32 number.";
inline constexpr std::string_view dividesByZero =
    "a divisor is zero, or too close to zero for float32.";
inline constexpr std::string_view tooLarge =
    "more than four million operations; check for an endless loop or a derivative of very high "
    "order.";
inline constexpr std::string_view tooHighOrder =
    "derivatives of noise and textures are limited to order three; a warp's normal takes one "
    "derivative; in a chain of warps, each normal that a later warp reads takes another.";

inline constexpr std::string_view onlyInItsBody =
    "the states and the step number of a repeat can be used only in its function; use the result "
    "of repeat.";
inline constexpr std::string_view afterRepeat =
    "derivatives of a state of a repeat are known only after its end; differentiate the result of "
    "repeat.";

// Quotes user input, shortened to a single line.
std::string quoteShort(std::string_view text);

}  // namespace warpjet
