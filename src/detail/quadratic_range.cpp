#include "detail/quadratic_range.hpp"

#include <algorithm>

namespace warpjet {

void ValueRange::add(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

void ValueRange::add(const ValueRange& other) {
  low = std::min(low, other.low);
  high = std::max(high, other.high);
}

ValueRange rangeOnSegment(double start, double middle, double end) {
  ValueRange range{std::min(start, end), std::max(start, end)};
  // start + slope * t + bend * t^2
  const double bend = 2 * (start + end - 2 * middle), slope = end - start - bend;
  const double t = -slope / (2 * bend);
  if (t > 0 && t < 1) range.add(start + 0.5 * slope * t);
  return range;
}

ValueRange rangeOnTriangle(const std::array<double, 3>& corners,
                           const std::array<double, 3>& middles) {
  const auto& [a, b, c] = corners;
  const auto& [ab, bc, ac] = middles;
  ValueRange range = rangeOnSegment(a, ab, b);
  range.add(rangeOnSegment(b, bc, c));
  range.add(rangeOnSegment(a, ac, c));
  // a + x u + y v + xx u^2 + xy u v + yy v^2, where u and v are the weights of corners 1 and 2
  const double x = 4 * ab - 3 * a - b, y = 4 * ac - 3 * a - c;
  const double xx = 2 * (a + b - 2 * ab), yy = 2 * (a + c - 2 * ac);
  const double xy = 4 * (a + bc - ab - ac);
  const double determinant = 4 * xx * yy - xy * xy;
  const double u = (xy * y - 2 * yy * x) / determinant;
  const double v = (xy * x - 2 * xx * y) / determinant;
  if (u > 0 && v > 0 && u + v < 1) range.add(a + 0.5 * (x * u + y * v));
  return range;
}

}  // namespace warpjet
