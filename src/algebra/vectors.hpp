// Vector functions, composed of operations, so that none needs a derivative rule of its own.
// Formulas: the GLSL ES 3.00 specification, sections 8.4 and 8.5.
#pragma once

#include "algebra/value.hpp"

namespace warpjet {

Expression sum(const Value& v);
Expression dot(const Value& a, const Value& b);
Value cross(const Value& a, const Value& b);

// `normalize` returns zero for the zero vector. The derivatives of `length` and `normalize` are
// defined as zero there.
Expression length(const Value& v);
Value normalize(const Value& v);

Value reflect(const Value& incident, const Value& normal);
// Returns zero in case of total internal reflection.
Value refract(const Value& incident, const Value& normal, Expression eta);
Value faceforward(const Value& normal, const Value& incident, const Value& reference);

Value smoothstep(const Value& low, const Value& high, const Value& x);

}  // namespace warpjet
