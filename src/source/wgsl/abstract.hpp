// Computes with abstract numbers, which have 64 bits.
#pragma once

#include <optional>
#include <vector>

#include "source/wgsl/operand.hpp"

namespace warpjet::source::wgsl {

// Applies a binary operator, whose result has the type `type`; scalars are broadcast. Returns
// nullopt if there is no value.
std::optional<std::vector<double>> foldAbstract(Operator op, const Operand& left,
                                                const Operand& right, Type type);

// Applies a built-in function component by component. Returns nullopt if the function has no
// abstract result.
std::optional<std::vector<double>> foldAbstract(const BuiltIn& row,
                                                const std::vector<Operand>& operands, Type type);

}  // namespace warpjet::source::wgsl
