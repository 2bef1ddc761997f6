// Sums of derivatives: two terms enter, their sum leaves, written as a person would.
#pragma once

#include "graph/expression.hpp"

namespace warpjet {

// a / y + b / y is (a + b) / y: the derivative of a quotient stays one.
//
// a * k + b * k is (a + b) * k where a + b is computed anyway: the derivative of a turned point is
// the turned point times the angle's. So is c + a * k + (d + b * k) then c + d + (a + b) * k. That
// rounds in another order: by an ulp or two of the largest term.
Expression together(Expression x, Expression y);

}  // namespace warpjet
