#include "detail/triangulate.hpp"

#include <algorithm>
#include <utility>

namespace warpjet {

namespace {

using glm::dvec2;

// Returns twice the signed area, which is positive if the corners are counterclockwise.
double areaOf(dvec2 a, dvec2 b, dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Tests whether d is inside of the circle through a, b and c by more than rounding errors, so that
// neither diagonal of four points on a circle is replaced.
bool isInCircle(dvec2 a, dvec2 b, dvec2 c, dvec2 d) {
  const dvec2 u = a - d, v = b - d, w = c - d;
  const double uu = dot(u, u), vv = dot(v, v), ww = dot(w, w);
  const double inside =
      uu * (v.x * w.y - v.y * w.x) - vv * (u.x * w.y - u.y * w.x) + ww * (u.x * v.y - u.y * v.x);
  return inside > 1e-10 * (uu * vv + vv * ww + ww * uu);
}

class Triangulation {
 public:
  Triangulation(std::span<const dvec2> points, std::size_t hullSize) : points_(points) {
    for (std::uint32_t i = 2; i < hullSize; ++i) triangles_.push_back({0, i - 1, i});
    for (auto i = static_cast<std::uint32_t>(hullSize); i < points.size(); ++i) insert(i);
    flipAll();
  }

  std::vector<Corners> take() && { return std::move(triangles_); }

 private:
  double area(const Corners& t) const {
    return areaOf(points_[t[0]], points_[t[1]], points_[t[2]]);
  }

  // Splits the triangle that contains the point into three. If the point lies on a side, splits
  // both triangles at that side into two instead, since no triangle may be empty.
  void insert(std::uint32_t point) {
    const auto smallestArea = [&](const Corners& t) {
      return std::min(
          {area({t[0], t[1], point}), area({t[1], t[2], point}), area({t[2], t[0], point})});
    };
    auto found = triangles_.begin();
    double largest = smallestArea(*found);
    for (auto each = found + 1; each != triangles_.end(); ++each) {
      const double area = smallestArea(*each);
      if (!(largest < area)) continue;
      found = each;
      largest = area;
    }
    const Corners whole = *found;
    triangles_.erase(found);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = whole[i], b = whole[(i + 1) % 3];
      if (area({a, b, point}) > 1e-6)
        triangles_.push_back({a, b, point});
      else
        splitBeside(b, a, point);
    }
  }

  // Splits the triangle with this side, which contains the point, into two.
  void splitBeside(std::uint32_t a, std::uint32_t b, std::uint32_t point) {
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (triangles_[t][i] != a || triangles_[t][(i + 1) % 3] != b) continue;
        const std::uint32_t c = triangles_[t][(i + 2) % 3];
        triangles_[t] = {a, point, c};
        triangles_.push_back({point, b, c});
        return;
      }
    }
  }

  // Replaces diagonals until no circle around a triangle contains the opposite corner of a neighbor
  // (Lawson 1977). This ends, since each replacement lowers the surface through the points that are
  // lifted onto a paraboloid.
  void flipAll() {
    // The start and the end of a side; then its triangle, and the corner of the triangle at the
    // start.
    using Side = std::pair<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, int>>;
    std::vector<Side> sides;
    for (bool isChanged = true; isChanged;) {
      isChanged = false;
      sides.clear();
      for (std::size_t t = 0; t < triangles_.size(); ++t) {
        for (int i = 0; i < 3; ++i)
          sides.push_back({{triangles_[t][i], triangles_[t][(i + 1) % 3]}, {t, i}});
      }
      std::sort(sides.begin(), sides.end());
      std::vector<bool> isTouched(triangles_.size());
      for (const auto& [ends, place] : sides) {
        if (ends.first > ends.second) continue;
        const std::pair back{ends.second, ends.first};
        const auto opposite = std::lower_bound(sides.begin(), sides.end(), Side{back, {0, 0}});
        if (opposite == sides.end() || opposite->first != back) continue;
        const auto [s, i] = place;
        const auto [t, j] = opposite->second;
        if (isTouched[s] || isTouched[t]) continue;
        const std::uint32_t a = ends.first, b = ends.second;
        const std::uint32_t c = triangles_[s][(i + 2) % 3], d = triangles_[t][(j + 2) % 3];
        if (!isInCircle(points_[a], points_[b], points_[c], points_[d])) continue;
        triangles_[s] = {c, a, d};
        triangles_[t] = {d, b, c};
        isTouched[s] = isTouched[t] = isChanged = true;
      }
    }
  }

  std::span<const dvec2> points_;
  std::vector<Corners> triangles_;
};

}  // namespace

std::vector<Corners> triangulate(std::span<const dvec2> points, std::size_t hullSize) {
  return Triangulation(points, hullSize).take();
}

}  // namespace warpjet
