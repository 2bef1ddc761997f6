// Curved PN triangles, compared with values computed by hand from the formulas of the paper.
#include "detail/pn_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <vector>

#include "detail_support.hpp"

namespace warpjet {
namespace {

using glm::vec3;

Attribute vectors(const std::vector<vec3>& all, bool isUnit = false) {
  Attribute attribute{3, isUnit, {}};
  for (const vec3& v : all) attribute.values.insert(attribute.values.end(), {v.x, v.y, v.z});
  return attribute;
}

PnTriangles triangleOf(const std::vector<vec3>& corners, const std::vector<vec3>& normals) {
  return {BaseMesh({vectors(corners), vectors(normals, true)}, {{0, 1, 2}}), 1};
}

void expectNear(vec3 value, vec3 expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], 1e-6);
}

const std::vector<vec3> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// The side runs from (1, 0) to (0, 1), with normals that point away from the origin: its control
// points are (1, 1/3) and (1/3, 1).
TEST(PnTriangles, ASideIsACubicCurveThroughItsEndsAtRightAnglesToTheNormals) {
  const PnTriangles octant = triangleOf(axes, axes);
  expectNear(octant.position(0, {1, 0, 0}), {1, 0, 0});
  expectNear(octant.position(0, {0.5f, 0.5f, 0}), {0.625f, 0.625f, 0});
  const float third = 1.0f / 3;
  expectNear(octant.position(0, {2 * third, third, 0}), {22.0f / 27, 11.0f / 27, 0});
}

// The center's position and normal follow from the mean of the six side control points, which is
// (4/9, 4/9, 4/9).
TEST(PnTriangles, TheInnerControlPointLiesAboveTheSides) {
  const PnTriangles octant = triangleOf(axes, axes);
  const float third = 1.0f / 3;
  expectNear(octant.position(0, {third, third, third}), vec3(4.0f / 9));
  expectNear(octant.normal(0, {third, third, third}), vec3(std::sqrt(third)));
}

TEST(PnTriangles, AFlatTriangleStaysFlatAndLinear) {
  const vec3 a(0, 0, 2), b(3, 0, 2), c(1, 4, 2), up(0, 0, 1);
  const PnTriangles flat = triangleOf({a, b, c}, {up, up, up});
  expectNear(flat.position(0, {0.2f, 0.5f, 0.3f}), 0.2f * a + 0.5f * b + 0.3f * c);
  expectNear(flat.position(0, {0, 0.25f, 0.75f}), 0.25f * b + 0.75f * c);
  expectNear(flat.normal(0, {0.2f, 0.5f, 0.3f}), up);
}

// With equal normals that lean along a side, the side becomes an S, whose slope changes its sign.
TEST(PnTriangles, NormalsFollowAnInflection) {
  const vec3 leaning(0.6f, 0, 0.8f);
  const PnTriangles wave =
      triangleOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {leaning, leaning, leaning});
  expectNear(wave.normal(0, {0.5f, 0.5f, 0}), {0, 0, 1});
}

// The arc is of 15 degrees, as on p5's sphere. The distance of its middle from the center, computed
// by hand, is cos(h) (1 + sin(h)^2 / 2) with h = 7.5 degrees, which is 0.99989.
TEST(PnTriangles, NormalsOfACircleAreThoseOfItsPoints) {
  const float angle = std::acos(-1.0f) / 12;
  const vec3 first(1, 0, 0), second(std::cos(angle), std::sin(angle), 0);
  const PnTriangles arc = triangleOf({first, second, {0, 0, 1}}, {first, second, {0, 0, 1}});
  for (const float t : {0.1f, 0.25f, 0.4f, 0.75f}) {
    const Weights weights{1 - t, t, 0};
    const vec3 position = arc.position(0, weights), normal = arc.normal(0, weights);
    EXPECT_NEAR(length(position), 1, 0.00011f);
    EXPECT_NEAR(std::atan2(position.y, position.x), std::atan2(normal.y, normal.x), 0.0003f);
  }
}

TEST(PnTriangles, CornersWithoutADirectionAreFlat) {
  const PnTriangles flat = triangleOf(axes, {vec3(0), vec3(NAN), vec3(0)});
  expectNear(flat.position(0, {0.5f, 0.5f, 0}), {0.5f, 0.5f, 0});
  expectNear(flat.position(0, {0.25f, 0.25f, 0.5f}), {0.25f, 0.25f, 0.5f});
  expectNear(flat.normal(0, {0.5f, 0.25f, 0.25f}), vec3(0));
  // A triangle with two corners in one place, as at the pole of a sphere.
  const PnTriangles sliver = triangleOf({axes[0], axes[1], axes[1]}, {axes[0], axes[1], axes[1]});
  expectNear(sliver.position(0, {0, 0.5f, 0.5f}), axes[1]);
  expectNear(sliver.normal(0, {0, 0.5f, 0.5f}), axes[1]);
}

// A prism with `count` sides and caps, whose walls have the normals of a cylinder of radius 1.
// Each face has vertices of its own.
struct Prism {
  std::vector<vec3> positions, normals;
  std::vector<std::uint32_t> indices;

  void add(vec3 position, vec3 normal) {
    indices.push_back(static_cast<std::uint32_t>(positions.size()));
    positions.push_back(position);
    normals.push_back(normal);
  }

  explicit Prism(int count) {
    const auto at = [&](int i) {
      const float angle =
          2 * std::acos(-1.0f) * static_cast<float>(i % count) / static_cast<float>(count);
      return vec3(std::cos(angle), std::sin(angle), 0);
    };
    const vec3 up(0, 0, 1);
    for (int i = 0; i < count; ++i) {
      const vec3 a = at(i), b = at(i + 1);
      for (const vec3 wall : {a, b, b + up}) add(wall, wall.z > 0 ? wall - up : wall);
      for (const vec3 wall : {a, b + up, a + up}) add(wall, wall.z > 0 ? wall - up : wall);
      for (const vec3 cap : {up, a + up, b + up}) add(cap, up);
      for (const vec3 cap : {vec3(0), b, a}) add(cap, -up);
    }
  }
};

// Cuts the prism's edges to three lengths, like the detail module's caller, and subdivides it.
Detail subdivide(const Prism& prism, bool isCurved) {
  Detail detail({vectors(prism.positions), vectors(prism.normals, true)},
                static_cast<std::uint32_t>(prism.indices.size() / 3), {}, isCurved);
  detail.givenIndices() = prism.indices;
  detail.begin();
  for (const float length : {0.5f, 0.3f, 0.1f}) EXPECT_TRUE(detail.cut(length));
  EXPECT_TRUE(divide(detail, hill));
  return detail;
}

// Returns the minimum distance from the axis over the walls' vertices at z = 0 and z = 1.
float minRimRadius(const Detail& detail) {
  const std::vector<float>& p = detail.division().attributes[0].values;
  const std::vector<float>& normals = detail.division().attributes[1].values;
  float min = 1;
  for (std::size_t i = 0; i < p.size(); i += 3)
    if ((p[i + 2] == 0 || p[i + 2] == 1) && normals[i + 2] == 0)
      min = std::min(min, std::hypot(p[i], p[i + 1]));
  return min;
}

// The distance of the middle of a straight side from the axis is cos(30 degrees). The two control
// points lie 1/6 of that distance further out, so the middle moves out by 1/8 of it.
TEST(PnTriangles, ACylinderGetsRoundWithoutCracksAtItsRims) {
  const float straight = std::sqrt(0.75f);
  const Detail flat = subdivide(Prism(6), false), curved = subdivide(Prism(6), true);
  EXPECT_NEAR(minRimRadius(flat), straight, 1e-6);
  EXPECT_NEAR(minRimRadius(curved), straight * 9 / 8, 1e-6);
  expectClosed(curved);
}

TEST(PnTriangles, APoseMovesTheCurvedSurface) {
  Detail detail = subdivide(Prism(6), true);
  const std::vector<float> before = detail.samples()[0].values;
  // Rotates the prism by a quarter turn: (x, y, z) becomes (y, -x, z).
  for (int attribute = 0; attribute < 2; ++attribute) {
    std::vector<float>& v = detail.given(attribute);
    for (std::size_t i = 0; i < v.size(); i += 3)
      std::tie(v[i], v[i + 1]) = std::pair(v[i + 1], -v[i]);
  }
  detail.pose();
  const std::vector<float>& after = detail.samples()[0].values;
  for (std::size_t i = 0; i < after.size(); i += 3)
    expectNear({after[i], after[i + 1], after[i + 2]}, {before[i + 1], -before[i], before[i + 2]});
  EXPECT_TRUE(divide(detail, hill));
  expectClosed(detail);
}

}  // namespace
}  // namespace warpjet
