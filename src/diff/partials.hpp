// The partial derivatives of each row, as functions that build nodes.
#pragma once

#include <vector>

#include "graph/expression.hpp"

namespace warpjet {

// By an operand of an operation.
struct Partial {
  // From all operands, the operation's own node and the derivative of that operand to the node of
  // their product; null where the operation is locally constant.
  Expression (*times)(Graph&, const Operands<Expression>&, Expression value,
                      Expression derivative) = nullptr;
  // Whether it may overflow where the product does not.
  bool canOverflow = false;
};
using Partials = Operands<Partial>;

const Partials& partialsOf(Op op);

// An argument of a call, and the partial derivative by it.
struct Slope {
  NodeId argument, partial;
};

// Of a call of a function of the host, or of a result of one of ours, by the arguments that it has
// derivatives by.
std::vector<Slope> slopesOf(Graph& graph, NodeId id);

}  // namespace warpjet
