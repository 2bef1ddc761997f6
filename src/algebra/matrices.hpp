// Linear algebra on matrices of nodes with two to four columns and rows.
#pragma once

#include "algebra/value.hpp"

namespace warpjet {

// Multiplies two matrices, a matrix by a vector, or a row vector by a matrix.
Value multiply(const Value& a, const Value& b);
Value transpose(const Value& m);
Expression determinant(const Value& m);
// Returns the adjugate divided by the determinant: infinite or NaN if that is zero.
Value inverse(const Value& m);

// Returns a square matrix with `value` on the diagonal and zero elsewhere.
Value diagonal(int size, Expression value);

// Returns the matrix of a right-handed rotation: counterclockwise when the axis points at the
// viewer. The angle is in radians.
Value rotationAbout(int axis, Expression angle);
// Returns the rotation about an axis of any direction and length, by Rodrigues' formula.
Value rotationAbout(const Value& axis, Expression angle);

}  // namespace warpjet
