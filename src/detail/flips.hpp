// Chooses between the two diagonals of each quadrilateral of a tessellation: the one that is
// shorter in the metric of the triangle's bend errs less. A tessellation doesn't know that metric,
// since its numbers of pieces are rounded up, and shared with neighbors.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "detail/criterion.hpp"
#include "detail/triangulate.hpp"

namespace warpjet {

// The squared lengths of the three sides of a triangle in some metric.
using SquaredSides = std::array<float, 3>;

// The squared length of the diagonal c d minus that of a b, as a linear function of the squared
// sides.
struct Flip {
  std::array<float, 3> factors;

  // Tests whether the diagonal c d is clearly shorter.
  bool isShorter(const SquaredSides& sides) const {
    float sum = 0, sumOfSizes = 0;
    for (int i = 0; i < 3; ++i) {
      sum += factors[i] * sides[i];
      sumOfSizes += std::abs(factors[i] * sides[i]);
    }
    return sum < -criterion.minGain * sumOfSizes;
  }
};

// Pairs triangles into convex quadrilaterals, longest diagonals first. Then reorders the triangles:
// the halves of pair k are triangle 2k = (a, b, c) and triangle 2k + 1 = (b, a, d), and triangles
// without a partner come last. Pairs are in the order of their earlier triangle. `points` are
// weights of the corners of the whole triangle, and `sides` the squares of its sides, by which
// diagonals are compared.
std::vector<Flip> orderIntoPairs(std::vector<Corners>& triangles,
                                 std::span<const glm::dvec3> points, const SquaredSides& sides);

// Returns triangle `i` of those that `orderIntoPairs` has ordered, with the shorter diagonal.
Corners withShorterDiagonal(std::span<const Corners> triangles, std::span<const Flip> flips,
                            std::size_t i, const SquaredSides& sides);

}  // namespace warpjet
