// The functions that the rows of the table are written in, for plain numbers.
//
// A row's lambdas are generic in the scalar: called with `double` they find the functions below,
// called with a graph expression they find those of graph/expression.hpp by argument-dependent
// lookup. Definitions follow the GLSL ES 3.00 specification, chapter 8.
#pragma once

#include <cmath>

namespace warpjet::ops {

using std::abs, std::ceil, std::floor, std::trunc;
using std::acos, std::asin, std::atan, std::atan2, std::cos, std::sin, std::tan;
using std::acosh, std::asinh, std::atanh, std::cosh, std::sinh, std::tanh;
using std::exp, std::log, std::pow, std::sqrt;

inline constexpr double ln2 = 0.69314718055994530942;

inline double exp2(double x) { return std::pow(2, x); }
inline double log2(double x) { return std::log(x) / ln2; }
// Rounds half to even.
inline double round(double x) { return std::nearbyint(x); }

inline double inversesqrt(double x) { return 1 / std::sqrt(x); }
inline double sign(double x) { return (x > 0) - (x < 0); }
inline double fract(double x) { return x - std::floor(x); }
inline double mod(double x, double y) { return x - y * std::floor(x / y); }
inline double step(double edge, double x) { return x < edge ? 0 : 1; }
inline double mix(double x, double y, double t) { return x * (1 - t) + y * t; }
inline double min(double x, double y) { return y < x ? y : x; }
inline double max(double x, double y) { return x < y ? y : x; }

inline bool lt(double x, double y) { return x < y; }
inline bool le(double x, double y) { return x <= y; }
inline bool gt(double x, double y) { return x > y; }
inline bool ge(double x, double y) { return x >= y; }
inline bool eq(double x, double y) { return x == y; }
inline bool ne(double x, double y) { return x != y; }

inline bool logicalAnd(bool x, bool y) { return x && y; }
inline bool logicalOr(bool x, bool y) { return x || y; }
inline bool logicalNot(bool x) { return !x; }

inline double ifElse(bool condition, double yes, double no) { return condition ? yes : no; }

// Returns a term of a derivative; 0 where the condition is false. (An expression's term is only
// masked if its factor may be infinite.)
inline double maskTerm(bool condition, double, double term) { return condition ? term : 0; }

// A pseudorandom integer from 0 to 4090, computed from another such number and any integer.
//
// Cubing permutes the numbers modulo a prime that is 2 modulo 3, and is as far from linear as
// possible: differentially 2-uniform (Nyberg, "Differentially uniform mappings for cryptography",
// 1994). No product here reaches 2^24, so float computes every step as exactly as integers do.
inline constexpr double hashPrime = 4091, hashFactor = 1597, hashSummand = 823;

// Returns the remainder of x by the prime that is closest to 0, or its neighbor: the product with
// the inverse takes less time than a quotient, but may be rounded to the wrong side of a half.
// Remainders are at most 2047 from 0, so that the product of two is below 2^24.
template <class Scalar>
Scalar hashRemainder(Scalar x) {
  const Scalar prime = hashPrime, inverse = 1 / hashPrime;
  return x - prime * round(x * inverse);
}

template <class Scalar>
Scalar hashOf(Scalar h, Scalar i) {
  const Scalar factor = hashFactor, summand = hashSummand, prime = hashPrime;
  const Scalar x = hashRemainder(factor * (floor(h) + hashRemainder(floor(i))) + summand);
  const Scalar r = hashRemainder(hashRemainder(x * x) * x);
  return ifElse(lt(r, Scalar(0.0)), r + prime, r);
}

inline double hash(double h, double i) { return hashOf(h, i); }

}  // namespace warpjet::ops
