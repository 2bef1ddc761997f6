// Triangulation of polygons. The areas of the triangles must add up to that of the polygon, and
// every edge must be used in both directions or be a side of the polygon.
#include "mesh/obj/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <random>
#include <string>

namespace warpjet {
namespace {

using Points = std::vector<glm::dvec3>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Points flat(const std::vector<std::array<double, 2>>& points) {
  Points corners;
  for (const auto& [x, y] : points) corners.emplace_back(x, y, 0);
  return corners;
}

double cross(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.y - a.y * b.x; }

// Returns the area by the shoelace formula, a sum over the polygon's sides.
double areaOf(const Points& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

double areaOf(const Points& polygon, const std::array<std::uint32_t, 3>& t) {
  return cross(polygon[t[1]] - polygon[t[0]], polygon[t[2]] - polygon[t[0]]) / 2;
}

// Checks a simple counterclockwise polygon in the plane z = 0.
void expectExact(const Points& polygon, const std::string& what) {
  const Triangles triangles = trianglesOfPolygon(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2) << what;
  double sum = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const auto& triangle : triangles) {
    EXPECT_GE(areaOf(polygon, triangle), 0) << what;
    sum += areaOf(polygon, triangle);
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = triangle[i], b = triangle[(i + 1) % 3];
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  // No area is negative, so if the sum is correct, the triangles cover the polygon without overlap.
  EXPECT_NEAR(sum, areaOf(polygon), 1e-9 * areaOf(polygon)) << what;
  const auto last = static_cast<std::uint32_t>(polygon.size() - 1);
  for (std::uint32_t i = 0; i < last; ++i) balance[{i, i + 1}] -= 1;
  balance[{0, last}] += 1;
  for (const auto& [edge, count] : balance)
    EXPECT_EQ(count, 0) << what << ": " << edge.first << ' ' << edge.second;
}

TEST(Polygon, TriangulatesAConcavePolygonInsideItsOutline) {
  const Points dart = flat({{0, 0}, {4, 0}, {4, 4}, {3, 1}});
  EXPECT_EQ(areaOf(dart), 4);
  EXPECT_EQ(trianglesOfPolygon(dart), (Triangles{{3, 0, 1}, {1, 2, 3}}));
  expectExact(dart, "dart");
  expectExact(flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), "L");
  expectExact(flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}), "U");
  // Some corners are on straight sides or on edges between triangles; none may be omitted.
  expectExact(flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {1.5, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 1}}),
              "L with corners on its sides");
  // A square with a square hole, connected by a cut.
  expectExact(
      flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}),
      "hole");
  expectExact(flat({{0, 0}, {0, 0}, {4, 0}, {4, 4}, {4, 4}, {3, 1}}), "repeated corners");
}

// Most of the polygon is to the right of its first side.
TEST(Polygon, TriangulatesALetterCFromAnyCorner) {
  Points corners = flat({{1, 9}, {4, 9}, {4, 10}, {0, 10}, {0, 0}, {4, 0}, {4, 1}, {1, 1}});
  for (std::size_t i = 0; i < corners.size(); ++i) {
    expectExact(corners, "from corner " + std::to_string(i));
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  }
}

TEST(Polygon, TriangulatesConvexPolygonsAsFans) {
  EXPECT_EQ(trianglesOfPolygon(flat({{0, 0}, {2, 0}, {2, 2}, {1, 3}, {0, 2}})),
            (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(trianglesOfPolygon(flat({{0, 0}, {2, 0}, {0, 2}})), (Triangles{{0, 1, 2}}));
  EXPECT_TRUE(trianglesOfPolygon(flat({{0, 0}, {2, 0}})).empty());
}

TEST(Polygon, PreservesTheWindingInEveryPlane) {
  const Points dart = flat({{0, 0}, {4, 0}, {4, 4}, {3, 1}});
  for (const glm::dvec3& x : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0, 0.8)})
    for (const glm::dvec3& y : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)}) {
      Points inPlane;
      for (const glm::dvec3& p : dart) inPlane.push_back(x * p.x + (y + 0.1 * x) * p.y + 7.0);
      EXPECT_EQ(trianglesOfPolygon(inPlane), trianglesOfPolygon(dart));
    }
}

TEST(Polygon, TriangulatesAnySimplePolygon) {
  std::mt19937 random(1);
  const auto randomInteger = [&](int min, int max) {
    return min + static_cast<int>(random() % static_cast<unsigned>(max - min + 1));
  };
  for (int i = 0; i < 2000; ++i) {
    // A star-shaped polygon around a point that sees all of it.
    const int count = randomInteger(4, 40);
    Points star;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * k / count, radius = randomInteger(1, 9);
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    expectExact(star, "star " + std::to_string(i));
    // A skyline with integer coordinates, so that many corners are aligned.
    Points skyline = flat({{0, 0}});
    const int towers = randomInteger(2, 20);
    skyline.emplace_back(towers, 0, 0);
    for (int k = towers; k > 0; --k) {
      const int height = randomInteger(1, 4);
      skyline.emplace_back(k, height, 0);
      skyline.emplace_back(k - 1, height, 0);
    }
    expectExact(skyline, "skyline " + std::to_string(i));
  }
  // A spiral, in which no corner sees far.
  Points spiral;
  constexpr int length = 400;
  const auto add = [&](int k, double radius) {
    spiral.emplace_back(radius * std::cos(k * 0.2), radius * std::sin(k * 0.2), 0);
  };
  for (int k = 1; k < length; ++k) add(k, k + 5);
  for (int k = length - 1; k > 0; --k) add(k, k);
  expectExact(spiral, "spiral");
}

TEST(Polygon, TerminatesForSelfIntersectingPolygons) {
  std::mt19937 random(2);
  for (const std::size_t count : {4u, 5u, 10u, 100u, 4096u, 5000u}) {
    Points points;
    for (std::size_t i = 0; i < count; ++i)
      points.emplace_back(random() % 100, random() % 100, random() % 100);
    EXPECT_EQ(trianglesOfPolygon(points).size(), count - 2);
    EXPECT_EQ(trianglesOfPolygon(Points(count, points[0])).size(), count - 2);
  }
}

}  // namespace
}  // namespace warpjet
