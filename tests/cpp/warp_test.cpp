// The warp's normal, against formulas derived by hand.
#include "warp/warp.hpp"

#include <gtest/gtest.h>

#include "algebra/matrices.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

using Point = std::array<double, 3>;

class WarpTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Value p = vector3(graph, "position"), n = vector3(graph, "normal");
  Expression zero{&graph, graph.constant(0)};

  Value vec3(Expression x, Expression y, Expression z) {
    const Expression components[] = {x, y, z};
    return fill(graph, vectorOf(3), [&](int i) { return components[i]; });
  }

  Point normalOf(const Value& offset, Point position, Point normal) {
    const Value warped = warpNormal(deformation(differentiator, offset, p), n);
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
      inputs[p[i].id] = position[i];
      inputs[n[i].id] = normal[i];
    }
    return {evaluateNode(graph, warped[0].id, inputs), evaluateNode(graph, warped[1].id, inputs),
            evaluateNode(graph, warped[2].id, inputs)};
  }

  static void expectNear(const Point& a, const Point& b) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-14) << "component " << i;
  }
};

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

// The paper's equation follows the surface as a mirror turns it inside out: cof(diag(-1, 1, 1)) =
// diag(1, -1, -1). MirrorTest checks which side is the outer one.
TEST_F(WarpTest, ThePapersEquationFlipsTheNormalOfAMirror) {
  expectNear(normalOf(vec3(p[0] * -2.0, zero, zero), {0, 0, 0}, {0, 1, 0}), {0, -1, 0});
}

// x -> 0.5 x and y -> x: moved - position, where the ones of I + J cancel.
TEST_F(WarpTest, CancelsThePositionInMovedMinusPosition) {
  const Value offset = vec3(p[0] * 0.5 - p[0], p[0] + (p[1] * 0.25 - p[1]), zero);
  expectNear(normalOf(offset, {1, 2, 3}, {1, 0, 0}), {1, 0, 0});
  const double length = std::hypot(1.0, 0.5);
  expectNear(normalOf(offset, {1, 2, 3}, {0, 1, 0}), {-1 / length, 0.5 / length, 0});
}

// cof(M) n = (M u) x (M v) for tangents with u x v = n, here for a warp that rotates, scales and
// shears.
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

// Unless their gradients over the surface are given.
TEST_F(WarpTest, TreatsOtherInputsAsConstant) {
  expectNear(normalOf(n * 2.0, {1, 2, 3}, {0.6, 0, 0.8}), {0.6, 0, 0.8});
}

// M = I + J of x -> x + sin(y) z, y -> y + 0.3 x^2, z -> z + x, by hand.
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

// A tangent by finite differences of the moved curve p + s t, orthogonalized to the warped normal;
// and the bitangent with the same sign, also if the warp is a mirror.
TEST_F(WarpTest, TangentsFollowTheSurface) {
  const Value t = vector3(graph, "tangent");
  const Value wave = vec3(sin(p[1] * 2.0) * 0.3, p[0] * p[2] * 0.4, cos(p[0]) * 0.5);
  const Value mirrored = vec3(sin(p[1] * 2.0) * 0.3 - p[0] * 2.0, p[0] * p[2] * 0.4, zero);
  const Point at{0.3, -0.7, 0.9}, tangent{0.6, 0.8, 0}, normal{0, 0, 1}, bitangent{-0.8, 0.6, 0};
  for (const Value& offset : {wave, mirrored}) {
    const auto moved = [&](const Point& direction, double step) {
      Inputs inputs;
      for (int i = 0; i < 3; ++i) inputs[p[i].id] = at[i] + step * direction[i];
      Point result;
      for (int i = 0; i < 3; ++i)
        result[i] = inputs[p[i].id] + evaluateNode(graph, offset[i].id, inputs);
      return result;
    };
    const auto along = [&](const Point& direction) {
      const Point a = moved(direction, 1e-6), b = moved(direction, -1e-6);
      return Point{(a[0] - b[0]) / 2e-6, (a[1] - b[1]) / 2e-6, (a[2] - b[2]) / 2e-6};
    };
    const auto dotProduct = [](const Point& a, const Point& b) {
      return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const Point u = along(tangent), v = along(bitangent);
    Point across{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(dotProduct(across, across));
    for (double& x : across) x /= length;
    Point expected;
    for (int i = 0; i < 3; ++i) expected[i] = u[i] - across[i] * dotProduct(across, u);
    const double size = std::sqrt(dotProduct(expected, expected));

    const Value warped = warpNormal(deformation(differentiator, offset, p), n);
    const Value result = warpTangent(deformation(differentiator, offset, p), t, warped);
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
      inputs[p[i].id] = at[i];
      inputs[n[i].id] = normal[i];
      inputs[t[i].id] = tangent[i];
    }
    Point found, foundNormal;
    for (int i = 0; i < 3; ++i) {
      found[i] = evaluateNode(graph, result[i].id, inputs);
      foundNormal[i] = evaluateNode(graph, warped[i].id, inputs);
      EXPECT_NEAR(found[i], expected[i] / size, 1e-8) << "component " << i;
    }
    const Point side{foundNormal[1] * found[2] - foundNormal[2] * found[1],
                     foundNormal[2] * found[0] - foundNormal[0] * found[2],
                     foundNormal[0] * found[1] - foundNormal[1] * found[0]};
    EXPECT_GT(dotProduct(side, v), 0) << "the bitangent is on the other side";
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

// A torus by its angles, which are u and v, with the gradients of its normal (by the principal
// curvatures, do Carmo, "Differential Geometry of Curves and Surfaces", section 3.3) and of the
// angles.
struct TorusPoint {
  Point position, normal;
  std::array<Point, 5> gradients;
  double u, v;

  TorusPoint(double a, double b) : u(a), v(b) {
    constexpr double big = 2, small = 0.7;
    const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
    const double ring = big + small * cb;
    position = {ring * ca, ring * sa, small * sb};
    normal = {ca * cb, sa * cb, sb};
    const Point along{-sa, ca, 0}, around{-ca * sb, -sa * sb, cb};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i)
        gradients[i][k] = along[i] * along[k] * cb / ring + around[i] * around[k] / small;
      gradients[3][k] = along[k] / ring;
      gradients[4][k] = around[k] / small;
    }
  }
};

class SurfaceTest : public WarpTest {
 protected:
  Value uv = variable(graph, "uv", vectorOf(2));
  std::array<Value, 5> gradients{vector3(graph, "nx"), vector3(graph, "ny"), vector3(graph, "nz"),
                                 vector3(graph, "nu"), vector3(graph, "nv")};

  Value surfaceDeformation(const Value& offset) {
    Value m = deformation(differentiator, offset, p);
    const Expression inputs[] = {n[0], n[1], n[2], uv[0], uv[1]};
    for (std::size_t i = 0; i < 5; ++i)
      m = varyInput(differentiator, m, offset, inputs[i], gradients[i]);
    return m;
  }

  Inputs inputsAt(const TorusPoint& at) const {
    Inputs inputs{{uv[0].id, at.u}, {uv[1].id, at.v}};
    for (int k = 0; k < 3; ++k) {
      inputs[p[k].id] = at.position[k];
      inputs[n[k].id] = at.normal[k];
      for (std::size_t i = 0; i < 5; ++i) inputs[gradients[i][k].id] = at.gradients[i][k];
    }
    return inputs;
  }

  Point at(const Value& value, const TorusPoint& point) const {
    const Inputs inputs = inputsAt(point);
    Point found;
    for (int i = 0; i < 3; ++i) found[i] = evaluateNode(graph, value[i].id, inputs);
    return found;
  }

  // The normal of the moved surface, by differences along its angles.
  Point movedNormal(const Value& offset, double a, double b) const {
    const double step = 1e-5;
    const auto slope = [&](double da, double db) {
      const TorusPoint after(a + da, b + db), before(a - da, b - db);
      const Point x = at(p + offset, after), y = at(p + offset, before);
      return Point{(x[0] - y[0]) / (2 * step), (x[1] - y[1]) / (2 * step),
                   (x[2] - y[2]) / (2 * step)};
    };
    const Point s = slope(step, 0), t = slope(0, step);
    Point normal{s[1] * t[2] - s[2] * t[1], s[2] * t[0] - s[0] * t[2], s[0] * t[1] - s[1] * t[0]};
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (double& x : normal) x /= length;
    return normal;
  }

  void expectRight(const Value& offset) {
    const Value m = surfaceDeformation(offset);
    const Value warped = warpNormal(m, n);
    for (double a = 0.1; a < 6; a += 0.9) {
      for (double b = 0.2; b < 6; b += 0.7) {
        const Point found = at(warped, {a, b}), expected = movedNormal(offset, a, b);
        for (std::size_t i = 0; i < 3; ++i)
          EXPECT_NEAR(found[i], expected[i], 1e-8) << a << ", " << b;
      }
    }
  }
};

TEST_F(SurfaceTest, UsesTheGradientOfTheNormal) {
  expectRight(n * (sin(p[0] * 3.0) * 0.1 + cos(p[2] * 5.0) * p[1] * 0.05));
}

TEST_F(SurfaceTest, UsesTheGradientsOfTextureCoordinates) {
  expectRight(vec3(zero, zero, sin(uv[0] * 3.0) * cos(uv[1] * 2.0) * 0.2));
}

TEST_F(SurfaceTest, CombinesGradientsOfPositionNormalAndUv) {
  expectRight(vec3(n[0] * p[1] * 0.2 + n[1] * n[2] * 0.3, sin(uv[0] + n[2]) * 0.1 - p[0] * 0.5,
                   uv[1] * uv[0] * 0.02 * n[1] + sin(p[2] * 2.0) * 0.1));
}

// If the target is n itself, the position cancels: M is W alone, to the last digit.
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

// Inwards past the middle of the tube, but not past that of the ring: one direction of the surface
// is reversed, and the outer side becomes the inner side of the moved surface.
TEST_F(SurfaceTest, TheDeterminantIsNegativeWhereTheSidesAreSwapped) {
  const auto sign = [&](double amount) {
    const Value m = surfaceDeformation(n * amount);
    return evaluateNode(graph, determinant(m).id, inputsAt({0.5, 0.3}));
  };
  EXPECT_GT(sign(-0.6), 0);
  EXPECT_LT(sign(-0.8), 0);
  EXPECT_NEAR(sign(-0.7), 0, 1e-12);
}

class WholeWarpTest : public SurfaceTest {
 protected:
  Value t = variable(graph, "tangent", vectorOf(4));
  WarpInputs inputs{
      p, n, uv, t, {gradients[0], gradients[1], gradients[2], gradients[3], gradients[4]}};

  static void expectSame(const Value& a, const Value& b) {
    ASSERT_EQ(a.shape(), b.shape());
    for (int i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].id, b[i].id) << "component " << i;
  }
};

TEST_F(WholeWarpTest, CombinesPositionNormalAndTangent) {
  const Value offset = vec3(sin(p[1]) * n[2], p[0] * uv[1], n[0] * n[1]);
  const Warp warp = makeWarp(differentiator, offset, inputs);
  expectSame(warp.position, p + offset);
  EXPECT_TRUE(warp.varies);
  const Value along = vec3(t[0], t[1], t[2]);
  const auto expectParts = [&](const WarpedDirections& warped, const Value& m) {
    expectSame(warped.normal, warpNormal(m, n));
    const Value tangent = warpTangent(m, along, warped.normal);
    expectSame(warped.direction, multiply(m, along));
    EXPECT_EQ(warped.determinant.id, determinant(m).id);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(warped.tangent[i].id, tangent[i].id);
    EXPECT_EQ(warped.tangent[3].id, t[3].id) << "the side of the bitangent stays";
  };
  expectParts(*warp.flat, deformation(differentiator, offset, p));
  expectParts(*warp.surface, surfaceDeformation(offset));
}

// M t by differences of the moved curve p + s t, neither normalized nor orthogonal to the normal.
TEST_F(WholeWarpTest, TheDirectionIsTheTangentOfTheMovedCurve) {
  const Value offset = vec3(sin(p[1] * 2.0) * 0.3, p[0] * p[2] * 0.4, cos(p[0]) * 0.5);
  const Warp warp = makeWarp(differentiator, offset, inputs);
  const Point at{0.3, -0.7, 0.9}, along{0.6, 1.8, -0.4};
  const auto inputsAt = [&](double step) {
    Inputs all;
    for (std::size_t i = 0; i < 3; ++i) {
      all[p[static_cast<int>(i)].id] = at[i] + step * along[i];
      all[t[static_cast<int>(i)].id] = along[i];
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

// Normals, bitangents and triangles of warps that mirror space, against a mirror computed by hand.
class MirrorTest : public WholeWarpTest {
 protected:
  Expression u = scalar(graph, "u"), w = scalar(graph, "w");

  Warp warpOf(const Value& offset) {
    WarpInputs all = inputs;
    all.color = variable(graph, "color", vectorOf(4));
    return makeWarp(differentiator, offset, all);
  }

  // The warp that moves positions to `place`.
  Warp to(const Value& place) { return warpOf(place - p); }

  Inputs at(double uValue = 0.7, double wValue = 0.4) const {
    Inputs all{{u.id, uValue}, {w.id, wValue}};
    const double position[] = {0.3, -0.7, 0.9}, normal[] = {0.48, 0.6, 0.64};
    const double tangent[] = {0.8, 0, -0.6};
    for (int i = 0; i < 3; ++i) {
      all[p[i].id] = position[i];
      all[n[i].id] = normal[i];
      all[t[i].id] = tangent[i];
    }
    all[t[3].id] = 1;
    return all;
  }

  double signOf(const Warp& warp, double uValue = 0.7, double wValue = 0.4) {
    return evaluateNode(graph, warp.orientation->id, at(uValue, wValue));
  }

  bool isKnown(const Warp& warp) const { return graph.isConstant(warp.orientation->id); }

  // Rotates about an oblique axis, by an angle that grows with the height.
  Value screw(const Value& q, Expression by) {
    const Expression x{&graph, graph.constant(0.6)}, z{&graph, graph.constant(0.8)};
    return multiply(rotationAbout(vec3(x, zero, z), by), q);
  }

  Value twist(const Value& q) {
    const Expression angle = q[1] * 2.0;
    return vec3(cos(angle) * q[0] - sin(angle) * q[2], q[1], sin(angle) * q[0] + cos(angle) * q[2]);
  }
};

// (-x, y, z): the normal of a mirrored surface is the mirrored normal, and its bitangent is the
// mirrored bitangent.
TEST_F(MirrorTest, AMirrorMirrorsTheNormalAndTheBitangent) {
  const Warp warp = warpOf(vec3(p[0] * -2.0, zero, zero));
  ASSERT_TRUE(isKnown(warp));
  EXPECT_EQ(signOf(warp), -1);
  const double normal[] = {-0.48, 0.6, 0.64}, tangent[] = {-0.8, 0, -0.6, -1};
  for (const WarpedDirections& warped : {*warp.flat, *warp.surface}) {
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(evaluateNode(graph, warped.normal[i].id, at()), normal[i], 1e-15);
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(evaluateNode(graph, warped.tangent[i].id, at()), tangent[i], 1e-15);
    EXPECT_NEAR(evaluateNode(graph, warped.determinant.id, at()), -1, 1e-15);
  }
}

TEST_F(MirrorTest, TheRangeDeterminesASign) {
  const Expression x = p[0], y = p[1], z = p[2];
  const Value mirrors[] = {
      vec3(-x, -y, -z),
      vec3(-x * (y * y + 1.0), y, z),
      vec3(-(x * exp(y)), y, z),
      vec3(x * (sin(z) * 0.5 - 1.0), y, z),
      vec3(x * -2.0, y * (z * z + 3.0), z * 0.5),
      vec3(-(x * x * x + x), y, z),
      vec3(x / (-2.0 - y * y), y, z),
      vec3(-x, y + sin(x) * 3.0, z + x * y),
      vec3(y, x, z),
      twist(vec3(x * -2.0, y, z)),
      vec3(twist(p)[0] * -3.0, twist(p)[1], twist(p)[2]),
      screw(vec3(-x, y, z), u),
      screw(vec3(-x, y, z), x * 0.6 - z * 0.8),
      vec3(-(x - 1.0) - 1.0, y, z),
      vec3((x - 1.0) * -2.0 + x - 1.0, y, z),
  };
  for (const Value& place : mirrors) {
    const Warp warp = to(place);
    EXPECT_TRUE(isKnown(warp)) << "mirror " << &place - mirrors;
    EXPECT_EQ(signOf(warp), -1) << "mirror " << &place - mirrors;
  }
}

// These need no code.
TEST_F(MirrorTest, WarpsThatDoNotMirrorUseTheEquationOfThePaper) {
  const Expression x = p[0], y = p[1], z = p[2];
  const Value others[] = {
      p,
      twist(p),
      screw(p, u),
      screw(p, x * 0.6 + z * 0.8),
      vec3(-x, -y, z),
      vec3(x * (y * y + 1.0), y, z),
      vec3(zero, y, z),                  // flattened
      vec3(x * x, y, z),                 // folded
      vec3(-x * y, y, z),                // mirrored on one side
      vec3(x + n[0] * -3.0, y, z),       // depends on the normal
      vec3(-x * uv[0], y, z),            // one half of the texture
      vec3(x * (y + 2e4) * -1.0, y, z),  // mirrored except at distant places
  };
  for (const Value& place : others) {
    const Warp warp = to(place);
    EXPECT_TRUE(isKnown(warp)) << "warp " << &place - others;
    EXPECT_EQ(signOf(warp), 1) << "warp " << &place - others;
  }
}

TEST_F(MirrorTest, AttributesDoNotDetermineASign) {
  const Value color = variable(graph, "color", vectorOf(4));
  for (const Expression attribute : {color[2], t[0], t[3], gradients[0][1]})
    EXPECT_TRUE(isKnown(to(vec3(p[0] * attribute, p[1], p[2]))));
}

TEST_F(MirrorTest, UniformsDetermineASign) {
  const Expression x = p[0], y = p[1], z = p[2];
  const Value ofU[] = {
      vec3(x * u, y, z),
      vec3(x * (u - 1.0) + x, y, z),
      vec3(x * u * (y * y + 1.0), y, z),
      twist(vec3(x * u, y, z)),
      twist(p * Value(u)),
      vec3(twist(p)[0] * u, twist(p)[1], twist(p)[2]),
      vec3(x * u * w, y * w, z),
      vec3(x * u + y * w, y, z),
      vec3(x * sin(u) / 3.0, y, z),
      vec3(x * (y * y + 1.0) / u, y, z),
      screw(vec3(x * u, y, z), w),
  };
  for (const Value& place : ofU) {
    const Warp warp = to(place);
    EXPECT_FALSE(isKnown(warp)) << "warp " << &place - ofU;
    EXPECT_EQ(signOf(warp, 0.7), 1) << "warp " << &place - ofU;
    EXPECT_EQ(signOf(warp, -0.7), -1) << "warp " << &place - ofU;
    EXPECT_EQ(signOf(warp, -0.7, -0.4), -1) << "warp " << &place - ofU;
    EXPECT_EQ(signOf(warp, 0), 1) << "flattened: warp " << &place - ofU;
  }
  EXPECT_EQ(signOf(to(vec3(x * u, y * u, z))), 1);
  EXPECT_TRUE(isKnown(to(vec3(x * u, y * u, z)))) << "a square";
  EXPECT_TRUE(isKnown(to(vec3(x * exp(u), y, z))));
  EXPECT_TRUE(isKnown(to(vec3(x + u, y * w - y * w + y, z)))) << "read, but not by M";
}

// Signs multiply: a factor that mirrors for some values of a uniform, times a part whose sign is
// known.
TEST_F(MirrorTest, SignsMultiply) {
  const Warp warp = to(twist(vec3(p[0] * u, p[1], p[2] * -2.0)));
  EXPECT_EQ(signOf(warp, 0.7), -1);
  EXPECT_EQ(signOf(warp, -0.7), 1);
}

// With zero gradients the surface is flat, and space itself is mirrored.
TEST_F(MirrorTest, AnOffsetAlongTheNormalIsMirroredLikeSpace) {
  const Warp warp = warpOf(vec3(p[0] * -2.0, zero, zero) + n * 0.1);
  EXPECT_EQ(signOf(warp), -1);
  Inputs all = at();
  for (const Value& gradient : gradients)
    for (int i = 0; i < 3; ++i) all[gradient[i].id] = 0;
  const double normal[] = {-0.48, 0.6, 0.64};
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(evaluateNode(graph, warp.surface->normal[i].id, all), normal[i], 1e-15);
}

}  // namespace
}  // namespace warpjet
