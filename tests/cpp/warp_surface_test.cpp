// Normals and tangents of warps whose offset depends on more than the position, on a torus.
#include <gtest/gtest.h>

#include "warp_support.hpp"

namespace warpjet {
namespace {

TEST_F(SurfaceTest, UsesTheGradientOfTheNormal) {
  expectCorrectNormals(n * (sin(p[0] * 3.0) * 0.1 + cos(p[2] * 5.0) * p[1] * 0.05));
}

TEST_F(SurfaceTest, UsesTheGradientsOfTextureCoordinates) {
  expectCorrectNormals(vec3(zero, zero, sin(uv[0] * 3.0) * cos(uv[1] * 2.0) * 0.2));
}

TEST_F(SurfaceTest, CombinesGradientsOfPositionNormalAndUv) {
  expectCorrectNormals(vec3(n[0] * p[1] * 0.2 + n[1] * n[2] * 0.3,
                            sin(uv[0] + n[2]) * 0.1 - p[0] * 0.5,
                            uv[1] * uv[0] * 0.02 * n[1] + sin(p[2] * 2.0) * 0.1));
}

// The offset n - p moves each point to its normal, so the position cancels: M consists of the
// gradients of the normal, without rounding.
TEST_F(SurfaceTest, CancelsThePositionExactlyInTargetMinusPosition) {
  const Value m = surfaceDeformation(n - p);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(m[i].id, gradients[i % 3][i / 3].id);
}

TEST_F(SurfaceTest, EqualsTheDeformationIfOnlyThePositionIsRead) {
  const Value offset = vec3(sin(p[1]) * p[2], p[0] * p[0] * 0.3, p[0]);
  const Value m = surfaceDeformation(offset);
  const Value known = deformation(differentiator, offset, p);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(m[i].id, known[i].id);
}

// Moves the surface inwards past the middle of the tube, but not past that of the ring: one
// direction of the surface is reversed, and its outer side becomes the inner one.
TEST_F(SurfaceTest, TheDeterminantIsNegativeWhereTheSidesAreSwapped) {
  const auto sign = [&](double amount) {
    const Value m = surfaceDeformation(n * amount);
    return evaluateNode(graph, determinant(m).id, inputsAt({0.5, 0.3}));
  };
  EXPECT_GT(sign(-0.6), 0);
  EXPECT_LT(sign(-0.8), 0);
  EXPECT_NEAR(sign(-0.7), 0, 1e-12);
}

TEST_F(WholeWarpTest, CombinesPositionNormalAndTangent) {
  const Value offset = vec3(sin(p[1]) * n[2], p[0] * uv[1], n[0] * n[1]);
  const Warp warp = makeWarp(differentiator, offset, inputs);
  expectSame(warp.position, p + offset);
  EXPECT_TRUE(warp.varies);
  const Value direction = vec3(t[0], t[1], t[2]);
  const auto expectParts = [&](const WarpedDirections& warped, const Value& m) {
    expectSame(warped.normal, warpNormal(m, n));
    const Value tangent = warpTangent(m, direction, warped.normal);
    expectSame(warped.direction, multiply(m, direction));
    EXPECT_EQ(warped.determinant.id, determinant(m).id);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(warped.tangent[i].id, tangent[i].id);
    EXPECT_EQ(warped.tangent[3].id, t[3].id) << "the sign of the bitangent is unchanged";
  };
  expectParts(*warp.flat, deformation(differentiator, offset, p));
  expectParts(*warp.surface, surfaceDeformation(offset));
}

// Compares M t, which is neither normalized nor orthogonal to the normal, with finite differences
// along the moved curve p + s t.
TEST_F(WholeWarpTest, TheDirectionIsTheTangentOfTheMovedCurve) {
  const Value offset = vec3(sin(p[1] * 2.0) * 0.3, p[0] * p[2] * 0.4, cos(p[0]) * 0.5);
  const Warp warp = makeWarp(differentiator, offset, inputs);
  const Point position{0.3, -0.7, 0.9}, direction{0.6, 1.8, -0.4};
  const auto inputsAt = [&](double step) {
    Inputs all;
    for (std::size_t i = 0; i < 3; ++i) {
      all[p[static_cast<int>(i)].id] = position[i] + step * direction[i];
      all[t[static_cast<int>(i)].id] = direction[i];
    }
    return all;
  };
  for (int i = 0; i < 3; ++i) {
    const double after = evaluateNode(graph, warp.position[i].id, inputsAt(1e-6));
    const double before = evaluateNode(graph, warp.position[i].id, inputsAt(-1e-6));
    EXPECT_NEAR(evaluateNode(graph, warp.flat->direction[i].id, inputsAt(0)),
                (after - before) / 2e-6, 1e-9);
  }
}

TEST_F(WholeWarpTest, AnOffsetThatReadsOnlyThePositionNeedsNoGradients) {
  const Warp warp = makeWarp(differentiator, vec3(sin(p[1]), zero, zero), inputs);
  EXPECT_FALSE(warp.varies);
  expectSame(warp.flat->normal, warp.surface->normal);
  // Reading the normal is not the same as depending on it.
  const Warp cancelled = makeWarp(differentiator, vec3(n[0] - n[0] + p[1], zero, zero), inputs);
  EXPECT_FALSE(cancelled.varies);
}

TEST_F(WholeWarpTest, ComputesOnlyTheRequestedParts) {
  const Value offset = n * p[0];
  const Warp moved = makeWarp(differentiator, offset, inputs, {.needsDirections = false});
  EXPECT_FALSE(moved.flat || moved.surface);
  const Warp warped = makeWarp(differentiator, offset, inputs, {.isFlat = false});
  EXPECT_FALSE(warped.flat);
  EXPECT_TRUE(warped.surface);
}

}  // namespace
}  // namespace warpjet
