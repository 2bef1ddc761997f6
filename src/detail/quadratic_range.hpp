// Exact ranges of quadratic polynomials.
#pragma once

#include <array>
#include <cmath>

namespace warpjet {

// Empty at first.
struct ValueRange {
  double low = INFINITY, high = -INFINITY;

  bool isEmpty() const { return low > high; }
  double length() const { return high - low; }
  void add(double value);
  void add(const ValueRange& other);
};

// Returns the range of a quadratic on a segment, given by its values at the start, in the middle
// and at the end.
ValueRange rangeOnSegment(double start, double middle, double end);

// Returns the range of a quadratic on a triangle, given by its values at the corners, and in the
// middles of the sides between corners 0 and 1, 1 and 2, 0 and 2.
ValueRange rangeOnTriangle(const std::array<double, 3>& corners,
                           const std::array<double, 3>& middles);

}  // namespace warpjet
