#include <cmath>

#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// The inverse of the max value that unit vectors can give, by dimension: the maximum of the sum of
// (reach - d²)⁴ d over a simplex, where d are the distances from its corners.
constexpr double scales[] = {0, 3.16049, 99.2043, 107.6534, 108.5678};

// Returns the squared radius of a corner's kernel: the squared height of such a simplex, which is
// the same in all dimensions but the first.
constexpr double reachOf(int dimensions) { return dimensions == 1 ? 1 : 0.5; }

Expression sum(const Numbers& x) {
  Expression total = x[0];
  for (std::size_t i = 1; i < x.size(); ++i) total = total + x[i];
  return total;
}

// Returns for each coordinate how many others it is at least as large as. Of equal coordinates, the
// first counts as the largest.
Numbers ranks(const Numbers& x) {
  Graph& graph = *x[0].graph;
  Numbers all;
  for (std::size_t i = 0; i < x.size(); ++i) all.push_back({&graph, graph.constant(0)});
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = i + 1; k < x.size(); ++k) {
      const Expression wins = step(x[k], x[i]);
      all[i] = all[i] + wins;
      all[k] = all[k] + (1.0 - wins);
    }
  }
  return all;
}

// Returns 1 if the path to the given corner, numbered from 0 to n, includes a step along the
// coordinate of this rank, else 0.
Expression countStep(Expression rank, int corner, int n) {
  if (corner == 0 || corner == n) return {rank.graph, rank.graph->constant(corner == n ? 1 : 0)};
  return step(static_cast<double>(n - corner), rank);
}

// A point in a grid of cubes that is compressed along its diagonal until the simplices of each cube
// are regular; in one dimension, the grid is unchanged. Large numbers cancel first, so that a
// distant point is as precise as a near one: with cells P + f of the point, skew S of their sum,
// and S = s + s' of an integer and a fraction, p - (cell - unskew * sum(cell)) is a sum of
// fractions.
struct Skewed {
  Numbers whole, inside, step;
  Expression shift, fraction;

  Skewed(const Numbers& p, double skew)
      : shift{p[0].graph, p[0].graph->constant(0)}, fraction(shift) {
    for (const Expression x : p) {
      whole.push_back(floor(x));
      inside.push_back(fract(x));
    }
    // The product of `coarse` and an integer of up to 4096 is exact in float.
    const double coarse = std::round(skew * 4096) / 4096;
    const Expression cells = sum(whole), product = cells * coarse;
    shift = floor(product);
    fraction = fract(product) + cells * (skew - coarse);
    const Expression move = fraction + sum(inside) * skew;
    for (const Expression x : inside) step.push_back(floor(x + move));
  }

  Expression cell(int i) const { return whole[i] + shift + step[i]; }
};

}  // namespace

// With r the reach, o the offset from a corner, and m = r - |o|² where that is positive, the
// gradient of m⁴ (g · o) is m⁴ g - 8 m³ (g · o) o. Its length is at most m⁴ if g is orthogonal to
// o, and m³ |m - 8 |o|²| if it is parallel to o. Neither exceeds r³ m, since m <= r and since
// m² (8 r - 9 m) has its maximum 2048/2187 r³ at m = 16/27 r. It remains to bound the sum of m. If
// m is positive at k corners, the squared distances from them add up to at least those from their
// centroid, k (k - 1) e² / (2k), where e is the edge: so the sum is at most k r - (k - 1) e² / 2,
// with its maximum for all n + 1 corners.
double maxSlopeOfSimplexNoise(int dimensions) {
  const double n = dimensions, r = reachOf(dimensions);
  const double edge = dimensions == 1 ? 1 : n / (n + 1);  // squared
  return scales[dimensions] * r * r * r * ((n + 1) * r - n * edge / 2);
}

Expression simplexNoise(Library& library, const Numbers& p, Expression seed) {
  const int n = static_cast<int>(p.size());
  const double root = std::sqrt(n + 1.0);
  const double skew = n == 1 ? 0 : (root - 1) / n, unskew = n == 1 ? 0 : (1 - 1 / root) / n;
  const Skewed skewed(p, skew);
  // The position of the point relative to the first corner of its simplex.
  const Expression moved =
      skewed.fraction * (n == 1 ? 0 : unskew / skew) + sum(skewed.step) * unskew;
  Numbers first;
  for (int i = 0; i < n; ++i) first.push_back(skewed.inside[i] - skewed.step[i] + moved);

  // The path from each corner of the simplex to the next is a step along the largest remaining
  // coordinate.
  const Numbers rank = ranks(first);
  Expression total{seed.graph, seed.graph->constant(0)};
  for (int corner = 0; corner <= n; ++corner) {
    Expression cellHash = seed;
    Numbers offset;
    for (int i = 0; i < n; ++i) {
      const Expression taken = countStep(rank[i], corner, n);
      cellHash = hash(cellHash, skewed.cell(i) + taken);
      offset.push_back(first[i] - taken + corner * unskew);
    }
    const Expression near = max(reachOf(n) - dot(offset, offset), 0.0);
    total =
        total + near * near * (near * near) * dot(randomDirection(library, cellHash, n), offset);
  }
  return total * scales[n];
}

}  // namespace warpjet
