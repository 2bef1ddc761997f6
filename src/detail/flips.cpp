#include "detail/flips.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace warpjet {

namespace {

using glm::dvec3;

// Two triangles with a common side, (a, b, c) and (b, a, d), and the squared length of this side.
struct Quadrilateral {
  double square;
  std::size_t first, second;
  std::uint32_t a, b, c, d;
};

// Returns the factors of the squared sides in the squared length of a line. `line` is a difference
// of weights; each product of two of its components belongs to the side between these corners.
dvec3 squareOf(dvec3 line) { return {-line.x * line.y, -line.y * line.z, -line.z * line.x}; }

// Tests whether the quadrilateral is strictly convex: both triangles with the other diagonal have
// at least this share of the whole triangle's area.
bool isConvex(const Quadrilateral& quad, std::span<const dvec3> points) {
  constexpr double smallest = 1e-6;
  const auto area = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    return determinant(glm::dmat3(points[p], points[q], points[r]));
  };
  return area(quad.c, quad.a, quad.d) > smallest && area(quad.d, quad.b, quad.c) > smallest;
}

std::vector<Quadrilateral> quadrilateralsOf(std::span<const Corners> triangles,
                                            std::span<const dvec3> points, dvec3 sides) {
  // Maps the ends of a side, counterclockwise -> its triangle, and the opposite corner.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, std::uint32_t>> all;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i)
      all[{triangles[t][i], triangles[t][(i + 1) % 3]}] = {t, triangles[t][(i + 2) % 3]};
  }
  std::vector<Quadrilateral> quadrilaterals;
  for (const auto& [ends, place] : all) {
    const auto [a, b] = ends;
    const auto back = all.find({b, a});
    if (a > b || back == all.end()) continue;
    const auto [second, d] = back->second;
    const Quadrilateral quad{
        dot(squareOf(points[b] - points[a]), sides), place.first, second, a, b, place.second, d};
    if (isConvex(quad, points)) quadrilaterals.push_back(quad);
  }
  return quadrilaterals;
}

}  // namespace

std::vector<Flip> orderIntoPairs(std::vector<Corners>& triangles, std::span<const dvec3> points,
                                 const SquaredSides& sides) {
  std::vector<Quadrilateral> quadrilaterals =
      quadrilateralsOf(triangles, points, {sides[0], sides[1], sides[2]});
  std::stable_sort(
      quadrilaterals.begin(), quadrilaterals.end(),
      [](const Quadrilateral& p, const Quadrilateral& q) { return p.square > q.square; });
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> quadrilateralOf(triangles.size(), none);
  for (std::size_t i = 0; i < quadrilaterals.size(); ++i) {
    std::size_t& first = quadrilateralOf[quadrilaterals[i].first];
    std::size_t& second = quadrilateralOf[quadrilaterals[i].second];
    if (first == none && second == none) first = second = i;
  }
  std::vector<Flip> flips;
  std::vector<Corners> ordered, alone;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (quadrilateralOf[t] == none) {
      alone.push_back(triangles[t]);
      continue;
    }
    const auto& [square, first, second, a, b, c, d] = quadrilaterals[quadrilateralOf[t]];
    if (t != std::min(first, second)) continue;
    ordered.push_back({a, b, c});
    ordered.push_back({b, a, d});
    const glm::vec3 factors(squareOf(points[d] - points[c]) - squareOf(points[b] - points[a]));
    flips.push_back({{factors.x, factors.y, factors.z}});
  }
  ordered.insert(ordered.end(), alone.begin(), alone.end());
  triangles = std::move(ordered);
  return flips;
}

Corners withShorterDiagonal(std::span<const Corners> triangles, std::span<const Flip> flips,
                            std::size_t i, const SquaredSides& sides) {
  const Corners& triangle = triangles[i];
  if (i / 2 >= flips.size() || !flips[i / 2].isShorter(sides)) return triangle;
  // (a, b, c) becomes (c, a, d), and (b, a, d) becomes (d, b, c).
  return {triangle[2], triangle[0], triangles[i ^ 1][2]};
}

}  // namespace warpjet
