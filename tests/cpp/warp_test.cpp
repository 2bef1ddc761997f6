// Warped normals and tangents, compared with formulas derived by hand.
#include "warp/warp.hpp"

#include <gtest/gtest.h>

#include "warp_support.hpp"

namespace warpjet {
namespace {

TEST_F(WarpTest, AZeroOffsetOnlyNormalizesTheNormal) {
  expectNear(normalOf(vec3(zero, zero, zero), {1, 2, 3}, {0, 3, 4}), {0, 0.6, 0.8});
}

// z = sin(2x) over the plane z = 0 has the normal (-2 cos(2x), 0, 1).
TEST_F(WarpTest, AHeightFieldHasTheNormalOfItsGradient) {
  const double slope = 2 * std::cos(0.6), length = std::hypot(slope, 1.0);
  expectNear(normalOf(vec3(zero, zero, sin(p[0] * 2.0)), {0.3, 0, 0}, {0, 0, 1}),
             {-slope / length, 0, 1 / length});
}

// Scaling by (2, 1, 1) transforms the normal (1, 1, 0) to (1/2, 1, 0).
TEST_F(WarpTest, NormalsAreTransformedByTheCofactorMatrix) {
  expectNear(normalOf(vec3(p[0], zero, zero), {0, 0, 0}, {1, 1, 0}),
             {0.5 / std::hypot(0.5, 1.0), 1 / std::hypot(0.5, 1.0), 0});
}

// x -> 0 collapses all surfaces except those that face along x.
TEST_F(WarpTest, TheNormalIsZeroWhereTheSurfaceCollapses) {
  const Value flatten = vec3(-p[0], zero, zero);
  expectNear(normalOf(flatten, {1, 2, 3}, {0, 1, 0}), {0, 0, 0});
  expectNear(normalOf(flatten, {1, 2, 3}, {0.6, 0.8, 0}), {1, 0, 0});
  expectNear(normalOf(flatten, {1, 2, 3}, {0, 0, 0}), {0, 0, 0});
}

// A mirror turns the surface inside out, and the paper's equation follows it: cof(diag(-1, 1, 1)) =
// diag(1, -1, -1). MirrorTest checks that the normals of a warp point outwards.
TEST_F(WarpTest, ThePapersEquationFlipsTheNormalOfAMirror) {
  expectNear(normalOf(vec3(p[0] * -2.0, zero, zero), {0, 0, 0}, {0, 1, 0}), {0, -1, 0});
}

// The offset is moved - position, so the ones of I + J cancel.
TEST_F(WarpTest, CancelsThePositionInMovedMinusPosition) {
  const Value offset = vec3(p[0] * 0.5 - p[0], p[0] + (p[1] * 0.25 - p[1]), zero);
  expectNear(normalOf(offset, {1, 2, 3}, {1, 0, 0}), {1, 0, 0});
  const double length = std::hypot(1.0, 0.5);
  expectNear(normalOf(offset, {1, 2, 3}, {0, 1, 0}), {-1 / length, 0.5 / length, 0});
}

// cof(M) n = (M u) x (M v) for tangents with u x v = n. The warp rotates, scales and shears.
TEST_F(WarpTest, MatchesTheCrossProductOfWarpedTangents) {
  const Value offset = vec3(sin(p[1]) * p[2], p[0] * p[0] * 0.3, p[0] + cos(p[2]) * 0.5);
  const double x = 0.4, y = -0.8, z = 1.3;
  const double m[3][3] = {
      {1, std::cos(y) * z, std::sin(y)}, {0.6 * x, 1, 0}, {1, 0, 1 - 0.5 * std::sin(z)}};
  const Point u{1, 2, 0}, v{0, 1, 3};
  const auto warped = [&](const Point& t) {
    Point result{};
    for (std::size_t i = 0; i < 3; ++i)
      result[i] = m[i][0] * t[0] + m[i][1] * t[1] + m[i][2] * t[2];
    return result;
  };
  const auto crossed = [](const Point& a, const Point& b) {
    return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  Point expected = crossed(warped(u), warped(v));
  const double length = std::hypot(expected[0], expected[1], expected[2]);
  for (double& component : expected) component /= length;
  expectNear(normalOf(offset, {x, y, z}, crossed(u, v)), expected);
}

// Other inputs vary over the surface only if their gradients are given.
TEST_F(WarpTest, TreatsOtherInputsAsConstant) {
  expectNear(normalOf(n * 2.0, {1, 2, 3}, {0.6, 0, 0.8}), {0.6, 0, 0.8});
}

// M = I + J of x -> x + sin(y) z, y -> y + 0.3 x^2, z -> z + x is computed by hand.
TEST_F(WarpTest, TheDeformationIsTheIdentityPlusTheJacobian) {
  const Value m = deformation(differentiator, vec3(sin(p[1]) * p[2], p[0] * p[0] * 0.3, p[0]), p);
  const double x = 0.4, y = -0.8, z = 1.3;
  const Inputs inputs{{p[0].id, x}, {p[1].id, y}, {p[2].id, z}};
  const double expected[3][3] = {
      {1, 0.6 * x, 1}, {std::cos(y) * z, 1, 0}, {std::sin(y), 0, 1}};  // column by column
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row)
      EXPECT_NEAR(evaluateNode(graph, m.at(column, row).id, inputs), expected[column][row], 1e-15)
          << column << ", " << row;
  }
}

// Compares the tangent with finite differences along the moved curve p + s t, orthogonalized to the
// warped normal. The bitangent keeps its sign, also if the warp is a mirror.
TEST_F(WarpTest, TangentsFollowTheSurface) {
  const Value t = vector3(graph, "tangent");
  const Value wave = vec3(sin(p[1] * 2.0) * 0.3, p[0] * p[2] * 0.4, cos(p[0]) * 0.5);
  const Value mirrored = vec3(sin(p[1] * 2.0) * 0.3 - p[0] * 2.0, p[0] * p[2] * 0.4, zero);
  const Point position{0.3, -0.7, 0.9}, tangent{0.6, 0.8, 0}, normal{0, 0, 1},
      bitangent{-0.8, 0.6, 0};
  for (const Value& offset : {wave, mirrored}) {
    const auto moved = [&](const Point& direction, double step) {
      Inputs inputs;
      for (int i = 0; i < 3; ++i) inputs[p[i].id] = position[i] + step * direction[i];
      Point result;
      for (int i = 0; i < 3; ++i)
        result[i] = inputs[p[i].id] + evaluateNode(graph, offset[i].id, inputs);
      return result;
    };
    const auto slopeAlong = [&](const Point& direction) {
      const Point a = moved(direction, 1e-6), b = moved(direction, -1e-6);
      return Point{(a[0] - b[0]) / 2e-6, (a[1] - b[1]) / 2e-6, (a[2] - b[2]) / 2e-6};
    };
    const auto dotProduct = [](const Point& a, const Point& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const Point u = slopeAlong(tangent), v = slopeAlong(bitangent);
    Point movedNormal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                      u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(dotProduct(movedNormal, movedNormal));
    for (double& x : movedNormal) x /= length;
    Point expected;
    for (int i = 0; i < 3; ++i) expected[i] = u[i] - movedNormal[i] * dotProduct(movedNormal, u);
    const double size = std::sqrt(dotProduct(expected, expected));

    const Value warped = warpNormal(deformation(differentiator, offset, p), n);
    const Value result = warpTangent(deformation(differentiator, offset, p), t, warped);
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
      inputs[p[i].id] = position[i];
      inputs[n[i].id] = normal[i];
      inputs[t[i].id] = tangent[i];
    }
    Point found, foundNormal;
    for (int i = 0; i < 3; ++i) {
      found[i] = evaluateNode(graph, result[i].id, inputs);
      foundNormal[i] = evaluateNode(graph, warped[i].id, inputs);
      EXPECT_NEAR(found[i], expected[i] / size, 1e-8) << "component " << i;
    }
    const Point foundBitangent{foundNormal[1] * found[2] - foundNormal[2] * found[1],
                               foundNormal[2] * found[0] - foundNormal[0] * found[2],
                               foundNormal[0] * found[1] - foundNormal[1] * found[0]};
    EXPECT_GT(dotProduct(foundBitangent, v), 0) << "the bitangent has the wrong sign";
  }
}

TEST_F(WarpTest, TheTangentIsZeroWhereTheWarpCollapsesIt) {
  const Value t = vector3(graph, "tangent");
  const Value result = warpTangent(deformation(differentiator, vec3(-p[0], zero, zero), p), t, n);
  Inputs inputs{{p[0].id, 1.0}, {p[1].id, 2.0}, {p[2].id, 3.0}};
  for (int i = 0; i < 3; ++i) {
    inputs[t[i].id] = i == 0;
    inputs[n[i].id] = i == 1;
  }
  for (int i = 0; i < 3; ++i) EXPECT_EQ(evaluateNode(graph, result[i].id, inputs), 0);
}

}  // namespace
}  // namespace warpjet
