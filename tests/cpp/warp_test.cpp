// The warp's position and normal, against formulas worked out by hand.
#include "warp/warp.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace warpjet {
namespace {

using Point = std::array<double, 3>;

class WarpTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  std::array<Expression, 3> p = vector3(graph, "position");
  std::array<Expression, 3> n = vector3(graph, "normal");
  Expression zero{&graph, graph.constant(0)};

  static Vec3 ids(const std::array<Expression, 3>& v) { return {v[0].id, v[1].id, v[2].id}; }

  Point normalOf(const std::array<Expression, 3>& offset, Point position, Point normal) {
    const Vec3 warped = warpedNormal(differentiator, graph, ids(p), ids(n), ids(offset));
    std::map<NodeId, double> inputs;
    for (std::size_t i = 0; i < 3; ++i) {
      inputs[p[i].id] = position[i];
      inputs[n[i].id] = normal[i];
    }
    return {evaluateNode(graph, warped[0], inputs), evaluateNode(graph, warped[1], inputs),
            evaluateNode(graph, warped[2], inputs)};
  }

  static void expectNear(const Point& a, const Point& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-14) << "component " << i;
  }
};

TEST_F(WarpTest, NoOffsetLeavesTheNormalButMakesItUnit) {
  expectNear(normalOf({zero, zero, zero}, {1, 2, 3}, {0, 3, 4}), {0, 0.6, 0.8});
}

// z = sin(2x) over the plane z = 0 has the normal (-2 cos(2x), 0, 1).
TEST_F(WarpTest, AHeightFieldHasTheNormalOfItsGradient) {
  const double slope = 2 * std::cos(0.6), length = std::hypot(slope, 1.0);
  expectNear(normalOf({zero, zero, sin(p[0] * 2.0)}, {0.3, 0, 0}, {0, 0, 1}),
             {-slope / length, 0, 1 / length});
}

// Scaling by (2, 1, 1) turns (1, 1, 0) into (1/2, 1, 0).
TEST_F(WarpTest, NormalsTurnByTheCofactorNotByTheJacobian) {
  expectNear(normalOf({p[0], zero, zero}, {0, 0, 0}, {1, 1, 0}),
             {0.5 / std::hypot(0.5, 1.0), 1 / std::hypot(0.5, 1.0), 0});
}

// x -> 0 collapses all but the surfaces that face along x.
TEST_F(WarpTest, WhereTheSurfaceCollapsesTheNormalIsZero) {
  const std::array<Expression, 3> flatten{-p[0], zero, zero};
  expectNear(normalOf(flatten, {1, 2, 3}, {0, 1, 0}), {0, 0, 0});
  expectNear(normalOf(flatten, {1, 2, 3}, {0.6, 0.8, 0}), {1, 0, 0});
  expectNear(normalOf(flatten, {1, 2, 3}, {0, 0, 0}), {0, 0, 0});
}

// A mirror turns the surface inside out, and the normal with it: cof(diag(-1, 1, 1)) = diag(1, -1,
// -1).
TEST_F(WarpTest, AMirrorFlipsTheNormal) {
  expectNear(normalOf({p[0] * -2.0, zero, zero}, {0, 0, 0}, {0, 1, 0}), {0, -1, 0});
}

// x -> 0.5 x and y -> x: moved - position, where the ones of I + J cancel.
TEST_F(WarpTest, AMovedPositionMinusThePositionCancels) {
  const std::array<Expression, 3> offset{p[0] * 0.5 - p[0], p[0] + (p[1] * 0.25 - p[1]), zero};
  expectNear(normalOf(offset, {1, 2, 3}, {1, 0, 0}), {1, 0, 0});
  const double length = std::hypot(1.0, 0.5);
  expectNear(normalOf(offset, {1, 2, 3}, {0, 1, 0}), {-1 / length, 0.5 / length, 0});
}

TEST_F(WarpTest, PositionIsTheSum) {
  const Vec3 moved = warpedPosition(graph, ids(p), ids({p[1], zero, zero}));
  EXPECT_EQ(moved[0], (p[0] + p[1]).id);
  EXPECT_EQ(moved[1], p[1].id);
}

}  // namespace
}  // namespace warpjet
