// Noise on a grid: a function of each corner of the cell, blended across it.
#include <cmath>

#include "noise/bodies.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// 6t⁵ - 15t⁴ + 10t³: its first and second derivatives are 0 at 0 and 1.
Expression fade(Expression t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }

// `corner` gives the value at a corner from its hash and from where the point lies, seen from
// there.
template <class Corner>
class Lattice {
 public:
  Lattice(const Numbers& p, const Corner& corner) : corner_(corner) {
    for (const Expression x : p) {
      cell_.push_back(floor(x));
      offset_.push_back(fract(x));
      blend_.push_back(fade(offset_[offset_.size() - 1]));
    }
  }

  // The blend along this axis and all that follow.
  Expression from(std::size_t axis, Expression cellHash) {
    if (axis == cell_.size()) return corner_(cellHash, offset_);
    const Expression inside = offset_[axis];
    const Expression low = from(axis + 1, hash(cellHash, cell_[axis]));
    offset_[axis] = inside - 1.0;
    const Expression high = from(axis + 1, hash(cellHash, cell_[axis] + 1.0));
    offset_[axis] = inside;
    return low + blend_[axis] * (high - low);
  }

 private:
  const Corner& corner_;
  Numbers cell_, offset_, blend_;
};

}  // namespace

Expression gradientNoise(Library& library, const Numbers& p, Expression seed) {
  const int dimensions = static_cast<int>(p.size());
  const auto corner = [&](Expression cellHash, const Numbers& offset) {
    return dot(randomDirection(library, cellHash, dimensions), offset);
  };
  // In the middle of a cell, where all directions may point to it, lies the largest value.
  return Lattice(p, corner).from(0, seed) * (2 / std::sqrt(dimensions));
}

Expression valueNoise(const Numbers& p, Expression seed) {
  const auto corner = [](Expression cellHash, const Numbers&) {
    return cellHash * (2 / (ops::hashPrime - 1)) - 1.0;
  };
  return Lattice(p, corner).from(0, seed);
}

}  // namespace warpjet
