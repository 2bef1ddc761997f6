// Numbers that are known while a text is read, for lengths of arrays, labels of cases, heads of
// loops and indices.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "glsl/tree.hpp"

namespace warpjet::glsl {

// Of a scalar; a condition is 1 or 0. Nothing where it is not known, or needs a built-in function.
std::optional<double> constantNumber(const Tree& tree, ExpressionId expression);

std::optional<std::int32_t> constantInt(const Tree& tree, ExpressionId expression);

// Whether it is a constant expression (whose value may still be unknown here). `others` count as
// constant too: the counters of loops.
bool isConstant(const Tree& tree, ExpressionId expression, std::span<const VariableId> others = {});

}  // namespace warpjet::glsl
