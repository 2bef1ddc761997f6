// Linear algebra on matrices of nodes, of two to four columns and rows.
#pragma once

#include "algebra/value.hpp"

namespace warpjet {

// A matrix with a matrix, a vector behind it, or a vector before it, which then counts as a row.
Value multiply(const Value& a, const Value& b);
Value transpose(const Value& m);
Expression determinant(const Value& m);
// The adjugate divided by the determinant: infinite or NaN where that is zero.
Value inverse(const Value& m);

// `value` on the diagonal, zero elsewhere.
Value diagonal(int size, Expression value);

// Rotations, right-handed: counterclockwise for an eye that the axis points to. Radians.
Value rotationAbout(int axis, Expression angle);
// About any axis, whose length does not matter: Rodrigues' formula.
Value rotationAbout(const Value& axis, Expression angle);

}  // namespace warpjet
