// Algebraic identities, applied while a node is made.
#pragma once

#include <optional>

#include "graph/graph.hpp"

namespace warpjet {

// A simpler node of the same value, or nothing; may put the constant of a sum or product last.
// Which identities there are, and what each keeps of the value, is said in identities.hpp and
// turns.hpp. What jumps is folded on operands rounded to float32, as Graph::apply says.
// tests/cpp/simplify_test.cpp has an example of each way in which a value may differ.
//
// What turns back, such as sin²(x) + cos²(x) = 1, is folded as if sines and cosines were exact. A
// GPU's are not, and entries of a Jacobian that are folded and those that are not then differ by
// the factor sin² + cos²: tests/compile/normals.browser.test.js holds what that costs. In double it
// is off by a few ulps of the largest product.
std::optional<NodeId> simplify(Graph& graph, Op op, Operands<NodeId>& operands);

}  // namespace warpjet
