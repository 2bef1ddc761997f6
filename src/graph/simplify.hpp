// Algebraic identities, applied while a node is made.
#pragma once

#include <optional>

#include "graph/graph.hpp"

namespace warpjet {

// A simpler node of the same value, or nothing; may put the constant of a sum or product last.
//
// Ignored on purpose: that x may be infinite or NaN in x * 0 = 0, x - x = 0, 0 / x = 0 (or zero
// there), in what turns back by an angle x (see turns.hpp) and at the ends of mix, or NaN in a
// clamp between constants that cross; that x may be 0 or infinite in x / sqrt(x) = sqrt(x); and the
// sign of a zero. Rounded in another order: by an ulp or two (x * a) * b = x * (a * b) for
// constants and x * (1 / y) = x / y, by up to n ulps whole powers as products, by an ulp or two of
// the largest term (x + a) + b = x + (a + b) for constants; an intermediate that overflows or
// underflows in one order may not in the other. What jumps is folded on operands rounded to
// float32, as Graph::apply says. All else is exact. tests/cpp/simplify_test.cpp has an example of
// each.
//
// What turns back, such as sin²(x) + cos²(x) = 1, is folded as if sines and cosines were exact. A
// GPU's are not, and entries of a Jacobian that are folded and those that are not then differ by
// the factor sin² + cos²: tests/compile/normals.browser.test.js holds what that costs. In double it
// is off by a few ulps of the largest product.
std::optional<NodeId> simplify(Graph& graph, Op op, Operands<NodeId>& operands);

}  // namespace warpjet
