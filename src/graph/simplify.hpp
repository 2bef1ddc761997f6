// Algebraic identities, applied while a node is made.
#pragma once

#include <optional>

#include "graph/graph.hpp"

namespace warpjet {

// A simpler node of the same value, or nothing; may put the constant of a sum or product last.
//
// Ignored on purpose: that x may be infinite or NaN in x * 0 = 0, x - x = 0 and 0 / x = 0; the sign
// of a zero; and the rounding of a product of constants, (x * a) * b = x * (a * b), which is
// rounded once instead of twice. Every other identity is exact in floating point.
std::optional<NodeId> simplify(Graph& graph, Op op, Operands& operands);

}  // namespace warpjet
