#include <cmath>

#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// One over the largest value that directions of length 1 can give, by dimensions: the maximum of
// the sum of (reach - d²)⁴ d over a simplex, d being the distances from its corners.
constexpr double scales[] = {0, 3.16049, 99.2043, 107.6534, 108.5678};

Expression sum(Point x) {
  Expression total = x[0];
  for (const Expression next : x.subspan(1)) total = total + next;
  return total;
}

// How many coordinates each is at least as large as; of equal ones the first is the largest.
Numbers ranks(Point x) {
  Graph& graph = *x[0].graph;
  Numbers all(x.size(), Expression{&graph, graph.constant(0)});
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = i + 1; k < x.size(); ++k) {
      const Expression wins = step(x[k], x[i]);
      all[i] = all[i] + wins;
      all[k] = all[k] + (1.0 - wins);
    }
  }
  return all;
}

// Whether the way to a corner, counted from 0 to n, has gone along the coordinate of this rank: 1
// or 0.
Expression isTaken(Expression rank, int corner, int n) {
  if (corner == 0 || corner == n) return {rank.graph, rank.graph->constant(corner / n)};
  return step(static_cast<double>(n - corner), rank);
}

}  // namespace

Expression simplexNoise(Library& library, Point p, Expression seed) {
  const int n = static_cast<int>(p.size());
  // A grid of cubes, pressed along its diagonal until its simplices are regular; of one dimension
  // as it is.
  const double root = std::sqrt(n + 1.0);
  const double skew = n == 1 ? 0 : (root - 1) / n, unskew = n == 1 ? 0 : (1 - 1 / root) / n;
  const Expression skewed = sum(p) * skew;
  Numbers cell;
  for (const Expression x : p) cell.push_back(floor(x + skewed));
  const Expression unskewed = sum(cell) * unskew;
  Numbers first;
  for (int i = 0; i < n; ++i) first.push_back(p[i] - (cell[i] - unskewed));

  // From one corner of the simplex to the next goes a step along the largest coordinate that is
  // left.
  const Numbers rank = ranks(first);
  Expression total{seed.graph, seed.graph->constant(0)};
  for (int corner = 0; corner <= n; ++corner) {
    Expression cellHash = seed;
    Numbers offset;
    for (int i = 0; i < n; ++i) {
      const Expression taken = isTaken(rank[i], corner, n);
      cellHash = hash(cellHash, cell[i] + taken);
      offset.push_back(first[i] - taken + corner * unskew);
    }
    // The square of the height of such a simplex, whatever its dimension; of one dimension, its
    // own.
    const double reach = n == 1 ? 1 : 0.5;
    const Expression near = max(reach - dot(offset, offset), 0.0);
    total =
        total + near * near * (near * near) * dot(randomDirection(library, cellHash, n), offset);
  }
  return total * scales[n];
}

}  // namespace warpjet
