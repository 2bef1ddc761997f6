// Which types operators and constructors take: GLSL ES 3.00, sections 5.4 and 5.9. Nothing is
// converted by itself.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "glsl/operators.hpp"
#include "glsl/types.hpp"

namespace warpjet::glsl {

// The type of a result, or nothing where the operands do not fit.
std::optional<Type> typeOfBinary(Operator op, Type left, Type right, const Types& types);

// Why a type cannot be made of these, or nothing.
std::string constructorProblem(Type type, std::span<const Type> operands, const Types& types);

// The components that a selection such as `xzy` names, two bits each; nothing where it names none.
std::optional<int> readSwizzle(std::string_view letters, int size);

}  // namespace warpjet::glsl
