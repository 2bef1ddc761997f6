#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// Returns the derivative of a function's only value with respect to one of its arguments.
Expression slope(Expression value, int argument) {
  Graph& graph = *value.graph;
  return {&graph, graph.result(graph.operand(value.id, 0), 1 + argument)};
}

}  // namespace

Numbers curlNoise(Library& library, NoiseKind base, const Point& p, Expression seed) {
  const Expression x = callBase(library, base, p, hash(seed, 1)),
                   y = callBase(library, base, p, hash(seed, 2)),
                   z = callBase(library, base, p, hash(seed, 3));
  return {slope(z, 1) - slope(y, 2), slope(x, 2) - slope(z, 0), slope(y, 0) - slope(x, 1)};
}

}  // namespace warpjet
