// Pseudorandom numbers and directions from the hash of a cell. They are locally constant, so
// derivatives ignore them.
#pragma once

#include "functions/library.hpp"

namespace warpjet {

inline Expression hash(Expression h, Expression i) { return build(ops::find("hash"), h, i); }
inline Expression hash(Expression h, double i) {
  return hash(h, Expression{h.graph, h.graph->constant(i)});
}

// Returns `count` numbers from 0 to below 1 for a hash, which fill a square or cube evenly.
Numbers randomNumbers(Expression hash, int count);

// Returns a unit vector with that many dimensions; in one dimension, a number from -1 to 1.
Numbers randomDirection(Library& library, Expression hash, int dimensions);

inline Expression fract(Expression x) { return build(ops::find("fract"), x); }

inline Expression dot(const Numbers& x, const Numbers& y) {
  Expression sum = x[0] * y[0];
  for (std::size_t i = 1; i < x.size(); ++i) sum = sum + x[i] * y[i];
  return sum;
}

}  // namespace warpjet
