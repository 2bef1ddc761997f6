// Derivatives of numbers, vectors and matrices.
#pragma once

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// Returns the derivative of each component with respect to one component of an input.
Value derivative(Differentiator& differentiator, const Value& value, Expression input);
// Returns the derivatives of a number with respect to each component of the vector `inputs`.
Value gradient(Differentiator& differentiator, Expression value, const Value& inputs);
// Returns the Jacobian of a vector: one column for each component of `inputs`.
Value jacobian(Differentiator& differentiator, const Value& value, const Value& inputs);

}  // namespace warpjet
