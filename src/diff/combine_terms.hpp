// Adds two terms of a derivative and simplifies the sum as a person would.
#pragma once

#include "graph/expression.hpp"

namespace warpjet {

// Returns x + y. a / y + b / y becomes (a + b) / y: the derivative of a quotient remains one
// quotient.
//
// a * k + b * k becomes (a + b) * k if the graph contains a + b already: the derivative of a
// rotated point is the rotated point times the derivative of the angle. Likewise, c + a * k + (d +
// b * k) becomes c + d + (a + b) * k. The operations are rounded in another order, which changes
// the result by an ulp or two of the largest term.
Expression combineTerms(Expression x, Expression y);

}  // namespace warpjet
