// Applies algebraic identities while a node is made.
#pragma once

#include <optional>

#include "graph/graph.hpp"

namespace warpjet {

// Returns a simpler node of the same value, or nullopt; may swap operands to put the constant of a
// sum or product last. identities.hpp and rotations.hpp list the identities and how exactly each
// preserves the value. Discontinuous operations are folded on operands rounded to float32, as in
// Graph::apply. tests/cpp/simplify_test.cpp has an example of each way in which a value may differ.
//
// Rotations that cancel, such as sin²(x) + cos²(x) = 1, are folded as if sines and cosines were
// exact. A GPU's are not, so folded and unfolded entries of a Jacobian differ by the factor sin² +
// cos²; tests/compile/normals.browser.test.js bounds the error. In double precision it is a few
// ulps of the largest product.
std::optional<NodeId> simplify(Graph& graph, Op op, Operands<NodeId>& operands);

}  // namespace warpjet
