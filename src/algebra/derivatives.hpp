// Derivatives of numbers, vectors and matrices.
#pragma once

#include "algebra/value.hpp"
#include "diff/differentiator.hpp"

namespace warpjet {

// Of each component by one component of an input.
Value derivative(Differentiator& differentiator, const Value& value, Expression input);
// Of a number by each component of `inputs`, a vector.
Value gradient(Differentiator& differentiator, Expression value, const Value& inputs);
// Of a vector: one column for each component of `inputs`.
Value jacobian(Differentiator& differentiator, const Value& value, const Value& inputs);

}  // namespace warpjet
