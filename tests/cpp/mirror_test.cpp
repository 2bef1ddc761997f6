// Normals, bitangents and orientation of warps that mirror space, compared with a mirror computed
// by hand.
#include <gtest/gtest.h>

#include "warp_support.hpp"

namespace warpjet {
namespace {

class MirrorTest : public WholeWarpTest {
 protected:
  Expression u = scalar(graph, "u"), w = scalar(graph, "w");

  Warp warpOf(const Value& offset) {
    WarpInputs all = inputs;
    all.color = variable(graph, "color", vectorOf(4));
    return makeWarp(differentiator, offset, all);
  }

  // Returns the warp that moves positions to `target`.
  Warp warpTo(const Value& target) { return warpOf(target - p); }

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

  // Rotates about an oblique axis.
  Value screw(const Value& q, Expression angle) {
    const Expression x{&graph, graph.constant(0.6)}, z{&graph, graph.constant(0.8)};
    return multiply(rotationAbout(vec3(x, zero, z), angle), q);
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
  for (const Value& target : mirrors) {
    const Warp warp = warpTo(target);
    EXPECT_TRUE(isKnown(warp)) << "mirror " << &target - mirrors;
    EXPECT_EQ(signOf(warp), -1) << "mirror " << &target - mirrors;
  }
}

// The orientation of these warps is the constant 1, so it takes no code.
TEST_F(MirrorTest, WarpsThatDoNotMirrorUseTheEquationOfThePaper) {
  const Expression x = p[0], y = p[1], z = p[2];
  const Value unmirrored[] = {
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
      vec3(-x * uv[0], y, z),            // mirrored where u is positive
      vec3(x * (y + 2e4) * -1.0, y, z),  // mirrored except at distant places
  };
  for (const Value& target : unmirrored) {
    const Warp warp = warpTo(target);
    EXPECT_TRUE(isKnown(warp)) << "warp " << &target - unmirrored;
    EXPECT_EQ(signOf(warp), 1) << "warp " << &target - unmirrored;
  }
}

TEST_F(MirrorTest, AttributesDoNotDetermineASign) {
  const Value color = variable(graph, "color", vectorOf(4));
  for (const Expression attribute : {color[2], t[0], t[3], gradients[0][1]})
    EXPECT_TRUE(isKnown(warpTo(vec3(p[0] * attribute, p[1], p[2]))));
}

TEST_F(MirrorTest, UniformsDetermineASign) {
  const Expression x = p[0], y = p[1], z = p[2];
  const Value mirroredByU[] = {
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
  for (const Value& target : mirroredByU) {
    const Warp warp = warpTo(target);
    EXPECT_FALSE(isKnown(warp)) << "warp " << &target - mirroredByU;
    EXPECT_EQ(signOf(warp, 0.7), 1) << "warp " << &target - mirroredByU;
    EXPECT_EQ(signOf(warp, -0.7), -1) << "warp " << &target - mirroredByU;
    EXPECT_EQ(signOf(warp, -0.7, -0.4), -1) << "warp " << &target - mirroredByU;
    EXPECT_EQ(signOf(warp, 0), 1) << "flattened: warp " << &target - mirroredByU;
  }
  EXPECT_EQ(signOf(warpTo(vec3(x * u, y * u, z))), 1);
  EXPECT_TRUE(isKnown(warpTo(vec3(x * u, y * u, z)))) << "a square";
  EXPECT_TRUE(isKnown(warpTo(vec3(x * exp(u), y, z))));
  EXPECT_TRUE(isKnown(warpTo(vec3(x + u, y * w - y * w + y, z))))
      << "the offset reads uniforms, but M does not";
}

// One factor mirrors for some values of a uniform, the other has a known sign.
TEST_F(MirrorTest, SignsMultiply) {
  const Warp warp = warpTo(twist(vec3(p[0] * u, p[1], p[2] * -2.0)));
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
