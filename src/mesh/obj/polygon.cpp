// Written by hand, since no library packaged by Debian fits. CGAL's triangulations are under the
// GPL. tinyobjloader's own ear clipping is inside its file reader, and its results were wrong for
// 1,261 of 2,000 skylines of the tests; it can use Mapbox's earcut instead, which Debian ships only
// as a Python module. GEOS, GTS and GLU are libraries that would have to be ported, not headers;
// libtess2 is only available as a part of Tulip.
#include "mesh/obj/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>
#include <utility>

namespace warpjet {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Returns twice the signed area of a triangle, which is positive if a, b and c turn left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Projects the polygon to a coordinate plane: drops the coordinate in which the polygon's normal is
// largest, and leaves the other two exact. The result is counterclockwise.
std::vector<glm::dvec2> flatten(const std::vector<glm::dvec3>& corners) {
  // Twice the area's normal by Newell's method: the normal of the mean plane if the polygon isn't
  // planar.
  glm::dvec3 normal(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  int dropped = 0;
  for (const int axis : {1, 2})
    if (std::abs(normal[axis]) > std::abs(normal[dropped])) dropped = axis;
  int first = (dropped + 1) % 3, second = (dropped + 2) % 3;
  if (normal[dropped] < 0) std::swap(first, second);
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& corner : corners) flat.emplace_back(corner[first], corner[second]);
  return flat;
}

bool isConvex(const std::vector<glm::dvec2>& corners) {
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i)
    if (turn(corners[i], corners[(i + 1) % count], corners[(i + 2) % count]) < 0) return false;
  return true;
}

Triangles fan(std::size_t corners) {
  Triangles triangles;
  for (std::uint32_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

// The rest of a polygon while its ears are clipped.
class Remainder {
 public:
  explicit Remainder(std::vector<glm::dvec2> corners)
      : corners_(std::move(corners)),
        count_(corners_.size()),
        next_(count_),
        previous_(count_),
        isEar_(count_) {
    std::iota(next_.begin(), next_.end(), 1u);
    std::iota(previous_.begin() + 1, previous_.end(), 0u);
    next_.back() = 0;
    previous_.front() = static_cast<std::uint32_t>(count_ - 1);
    for (std::uint32_t i = 0; i < count_; ++i) isEar_[i] = isEarAt(i);
  }

  Triangles cut() {
    Triangles triangles;
    for (std::uint32_t corner = 0; count_ >= 3; --count_) {
      corner = nextEar(corner);
      const std::uint32_t before = previous_[corner], after = next_[corner];
      triangles.push_back({before, corner, after});
      next_[before] = after;
      previous_[after] = before;
      // Only these two corners can become ears or cease to be ears.
      isEar_[before] = isEarAt(before);
      isEar_[after] = isEarAt(after);
      // Continues after the neighbor, to avoid a fan of slivers.
      corner = next_[after];
    }
    return triangles;
  }

 private:
  double turnAt(std::uint32_t i) const {
    return turn(corners_[previous_[i]], corners_[i], corners_[next_[i]]);
  }

  // Returns true if no corner is inside of the triangle at this corner. Only reflex corners count:
  // if any corner is inside, a reflex corner is, too.
  bool isEarAt(std::uint32_t i) const {
    const glm::dvec2 &a = corners_[previous_[i]], &b = corners_[i], &c = corners_[next_[i]];
    if (turn(a, b, c) <= 0) return false;
    for (std::uint32_t k = next_[next_[i]]; k != previous_[i]; k = next_[k]) {
      const glm::dvec2& p = corners_[k];
      if (turn(a, b, p) < 0 || turn(b, c, p) < 0 || turn(c, a, p) < 0) continue;
      // Corners coincide where a cut leads to a hole.
      if (p == a || p == b || p == c) continue;
      if (turnAt(k) <= 0) return false;
    }
    return true;
  }

  // Returns the next ear from a corner on. If there is none, the rest is flat or self-intersecting;
  // then returns a straight corner, if there is one.
  std::uint32_t nextEar(std::uint32_t from) const {
    std::uint32_t straight = from;
    for (std::size_t i = 0; i < count_; ++i, from = next_[from]) {
      if (isEar_[from]) return from;
      if (turnAt(from) == 0) straight = from;
    }
    return straight;
  }

  std::vector<glm::dvec2> corners_;
  std::size_t count_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<bool> isEar_;
};

}  // namespace

Triangles trianglesOfPolygon(const std::vector<glm::dvec3>& corners) {
  if (corners.size() <= 3 || corners.size() > maxCutCorners) return fan(corners.size());
  std::vector<glm::dvec2> flat = flatten(corners);
  if (isConvex(flat)) return fan(corners.size());
  return Remainder(std::move(flat)).cut();
}

}  // namespace warpjet
