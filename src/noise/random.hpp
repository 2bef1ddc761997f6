// What looks random in noise: numbers and directions from the hash of a cell. All of it is locally
// constant, so derivatives pass it by.
#pragma once

#include "functions/library.hpp"

namespace warpjet {

inline Expression hash(Expression h, Expression i) { return build(ops::find("hash"), h, i); }
inline Expression hash(Expression h, double i) {
  return hash(h, Expression{h.graph, h.graph->constant(i)});
}

// So many numbers from 0 up to below 1 from a hash, which fill a square or cube evenly.
Numbers randomNumbers(Expression hash, int count);

// A vector of length 1 in so many dimensions; in one, a number from -1 to 1.
Numbers randomDirection(Library& library, Expression hash, int dimensions);

inline Expression fract(Expression x) { return build(ops::find("fract"), x); }

inline Expression dot(const Numbers& x, const Numbers& y) {
  Expression sum = x[0] * y[0];
  for (std::size_t i = 1; i < x.size(); ++i) sum = sum + x[i] * y[i];
  return sum;
}

}  // namespace warpjet
