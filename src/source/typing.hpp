// Checks the types of the operands of operators and constructors: GLSL ES 3.00, sections 5.4 and
// 5.9. There are no implicit conversions.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "source/operators.hpp"
#include "source/types.hpp"

namespace warpjet::source {

// Returns the type of the result, or nullopt if the operands don't match.
std::optional<Type> typeOfBinary(Operator op, Type left, Type right, const Types& types);

// Returns why a value can't be constructed from these operands; empty if it can.
std::string constructorProblem(Type type, std::span<const Type> operands, const Types& types);

// Packs the components of a swizzle such as `xzy`, two bits each; nullopt if it is invalid.
std::optional<int> readSwizzle(std::string_view letters, int size);

}  // namespace warpjet::source
