// The partial derivatives of each row, as functions that build nodes.
#pragma once

#include <array>
#include <vector>

#include "graph/expression.hpp"

namespace warpjet {

using Arguments = std::array<Expression, ops::maxArity>;

// From an operation's operands and its own node to the node of a partial derivative.
using Partial = NodeId (*)(Graph&, const Arguments&, Expression);
// One for each operand; null where the operation is locally constant.
using Partials = std::array<Partial, ops::maxArity>;

const Partials& partialsOf(Op op);

// An argument of a call, and the partial derivative by it.
struct Slope {
  NodeId argument, partial;
};

// Of a call of a function of the host, or of a result of one of ours, by the arguments that it has
// derivatives by.
std::vector<Slope> slopesOf(Graph& graph, NodeId id);

}  // namespace warpjet
