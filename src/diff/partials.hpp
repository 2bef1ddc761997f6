// The partial derivatives of each table row, as functions that build nodes.
#pragma once

#include <vector>

#include "graph/expression.hpp"

namespace warpjet {

// The partial derivative with respect to one operand.
struct Partial {
  // Takes all operands, the operation's own node and the derivative of this operand; returns the
  // product of the partial and that derivative. Null if the operation is locally constant.
  Expression (*times)(Graph&, const Operands<Expression>&, Expression value,
                      Expression derivative) = nullptr;
  // True if the partial may overflow where the product doesn't.
  bool canOverflow = false;
};
using Partials = Operands<Partial>;

const Partials& partialsOf(Op op);

// An argument of a call, and the partial derivative with respect to it.
struct Slope {
  NodeId argument, partial;
};

// Returns the slopes of a call of a host function, or of a result of one of our functions.
// Arguments with respect to which the function has no derivative are left out.
std::vector<Slope> slopesOf(Graph& graph, NodeId id);

}  // namespace warpjet
