// Pieces of the sentences that tell an artist what to change.
#pragma once

#include <string>
#include <string_view>

#include "graph/shape.hpp"
#include "module/syntax.hpp"

namespace warpjet {

// "a single number", "a vec3", "a mat3", "a matrix of 2 columns and 3 rows".
std::string shapeName(Shape shape);

// "no arguments were", "1 argument was", "3 arguments were".
std::string argumentCount(int count);

inline constexpr std::string_view notFinite =
    "the result of these constants is not a finite number that a shader can hold.";
inline constexpr std::string_view dividesByZero =
    "it divides by zero, or by a number too close to zero for a shader to hold.";
inline constexpr std::string_view tooLarge =
    "these are more than four million operations; does a loop never end, or is a derivative of a "
    "very high order?";
inline constexpr std::string_view tooHighOrder =
    "derivatives of noise and textures can be taken three times; a warp's normal takes one, and so "
    "does "
    "each normal that a chain hands on.";

inline constexpr std::string_view onlyInItsBody =
    "the state of a repeat, and the number of its step, are known only in its function; use what "
    "repeat gives.";
inline constexpr std::string_view afterRepeat =
    "derivatives of the state of a repeat are known only when it is over; take them of what repeat "
    "gives.";

// A text from outside, on one line and not too long, in quotation marks.
std::string quotedShort(std::string_view text);

}  // namespace warpjet
