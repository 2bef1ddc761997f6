// Noise on a grid: a function of each corner of the cell, blended across the cell.
#include <cmath>

#include "functions/fold.hpp"
#include "noise/bodies.hpp"
#include "noise/random.hpp"
#include "ops/scalar.hpp"

namespace warpjet {

namespace {

// Returns 6t⁵ - 15t⁴ + 10t³, whose first and second derivatives are 0 at 0 and 1.
Expression fade(Expression t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

// The value of a corner, computed from its hash and the offset of the point from it.
using Corner = Expression (*)(Library& library, Expression cellHash, const Numbers& offset);

class Lattice {
 public:
  Lattice(Library& library, const Point& p, Corner corner) : library_(library), corner_(corner) {
    for (const Expression x : p) {
      cell_.push_back(p.cell(cell_.size(), floor(x)));
      offset_.push_back(fract(x));
      blend_.push_back(fade(offset_[offset_.size() - 1]));
    }
  }

  // In 3D and above, the two sides of the cell along the first axis are computed in a loop instead
  // of being written out. That halves the time of the first draw, but later frames take a sixth to
  // more than a third longer. Milliseconds of the first draw, and of a later frame of 14,000
  // points, for warps with normals of fbm with 5 octaves in 3D (SwiftShader, minimum of 7 rounds):
  //
  //                                    written out       a loop
  //   fbm, GLSL 3.00                     95    23        47    27
  //   fbm, GLSL 1.00                    103    18        55    21
  //   fbm nested three deep, GLSL 3.00  252    44       106    56
  //   fbm nested three deep, GLSL 1.00  285    31       135    39
  //   the same of vectors, GLSL 3.00    600    83       249   114
  Expression value(Expression seed) {
    if (cell_.size() < 3) return valueFrom(0, seed);
    const Expression zero{seed.graph, seed.graph->constant(0)};
    const Expression inside = offset_[0];
    // The first step puts the first side in states[1], the second step moves it to states[0].
    const Numbers sides = fold(2, {zero, zero}, [&](const Numbers& states, Expression side) {
      offset_[0] = inside - side;
      return Numbers{states[1], valueFrom(1, hash(seed, cell_[0] + side))};
    });
    offset_[0] = inside;
    return between(0, sides[0], sides[1]);
  }

 private:
  // Blends along this axis and all following axes.
  Expression valueFrom(std::size_t axis, Expression cellHash) {
    if (axis == cell_.size()) return corner_(library_, cellHash, offset_);
    const Expression inside = offset_[axis];
    const Expression low = valueFrom(axis + 1, hash(cellHash, cell_[axis]));
    offset_[axis] = inside - 1.0;
    const Expression high = valueFrom(axis + 1, hash(cellHash, cell_[axis] + 1.0));
    offset_[axis] = inside;
    return between(axis, low, high);
  }

  Expression between(std::size_t axis, Expression low, Expression high) const {
    return low + blend_[axis] * (high - low);
  }

  Library& library_;
  Corner corner_;
  Numbers cell_, offset_, blend_;
};

Expression directionalRamp(Library& library, Expression cellHash, const Numbers& offset) {
  return dot(randomDirection(library, cellHash, static_cast<int>(offset.size())), offset);
}

Expression hashedValue(Library&, Expression cellHash, const Numbers&) {
  return cellHash * (2 / (ops::hashPrime - 1)) - 1.0;
}

// The max derivative of the blend, at its middle.
constexpr double maxSlopeOfFade = 15.0 / 8;

}  // namespace

// Noise is s Σ w (g · o) over the corners: s is the scale; w the weight of a corner, a product of
// blends, which add up to 1; g its direction and o the offset from it. Its derivative along an axis
// is s Σ w g' + s Σ w' (g · o), where g' is a component of g. The first sum is at most 1, as |g|
// is. In the second, w' is ±fade'(t) times the weight w₂ of the corner along the other axes, which
// add up to 1 on each side. So the sum is at most fade'(t) (Σ w₂ |o| + Σ w₂ |o₁|), where o and o₁
// are the offsets from the corners on the two sides. Along an axis, the mean square of an offset,
// (1 - fade) t² + fade (1 - t)², is at most 1/4; so by Jensen's inequality
// Σ w₂ |o| <= √(t² + (n - 1) / 4). With u = 2t - 1, both sums together are at most
// √(n + u²) <= √n (1 + u² / 2), and fade'(t) is 15/8 (1 - u²)², so their product has its maximum
// at u = 0: 15/8 √n.
double maxSlopeOfGradientNoise(int dimensions) {
  const double root = std::sqrt(dimensions);
  return 2 / root * (1 + maxSlopeOfFade * root);
}

// The derivative is fade'(t) Σ w₂ (high - low), where both values are between -1 and 1.
double maxSlopeOfValueNoise() { return maxSlopeOfFade * 2; }

Expression gradientNoise(Library& library, const Point& p, Expression seed) {
  // The maximum is in the middle of a cell, when all directions point to it.
  const double scale = 2 / std::sqrt(static_cast<double>(p.size()));
  return Lattice(library, p, directionalRamp).value(seed) * scale;
}

Expression valueNoise(Library& library, const Point& p, Expression seed) {
  return Lattice(library, p, hashedValue).value(seed);
}

}  // namespace warpjet
