// Compares vectors of nodes, and derivatives, with plain double arithmetic.
#include <gtest/gtest.h>

#include "algebra_support.hpp"

namespace warpjet {
namespace {

TEST_F(AlgebraTest, ComputesSumAndDot) {
  const Value a = makeVariable("a", {1, 2, 3, 4}), b = makeVariable("b", {5, -6, 7, 8});
  expectNear(sum(a), Doubles{10});
  expectNear(dot(a, b), Doubles{5 - 12 + 21 + 32});
}

TEST_F(AlgebraTest, CrossIsRightHandedAndPerpendicular) {
  const Value x = makeVariable("x", {1, 0, 0}), y = makeVariable("y", {0, 1, 0});
  expectNear(cross(x, y), Doubles{0, 0, 1});
  expectNear(cross(y, x), Doubles{0, 0, -1});
  expectNear(cross(makeVariable("a", {1, 2, 3}), makeVariable("b", {4, 5, 6})), Doubles{-3, 6, -3});
}

TEST_F(AlgebraTest, ComputesLengthAndNormalize) {
  expectNear(length(makeVariable("a", {3, 4})), Doubles{5});
  expectNear(length(makeVariable("b", {2, 3, 6})), Doubles{7});
  expectNear(length(makeVariable("c", {1, -1, 1, -1})), Doubles{2});
  expectNear(normalize(makeVariable("a", {3, 4})), Doubles{0.6, 0.8});
  expectNear(normalize(makeVariable("zero", {0, 0, 0})), Doubles{0, 0, 0});
}

TEST_F(AlgebraTest, ReflectMirrorsAtTheSurface) {
  expectNear(reflect(makeVariable("i", {1, -1}), makeVariable("n", {0, 1})), Doubles{1, 1});
  const Doubles incident{0.3, -0.7, 0.2}, normal = unit({1, 2, -2});
  const double normalComponent = dotOf(incident, normal);
  expectNear(reflect(makeVariable("i3", incident), makeVariable("n3", normal)),
             sumOf(incident, scaleBy(normal, -2 * normalComponent)));
}

// Snell's law makes the component along the surface eta times as long; the direction keeps unit
// length.
TEST_F(AlgebraTest, RefractFollowsSnell) {
  for (const double eta : {0.6, 1.0, 1.3}) {
    const Doubles normal = unit({1, 2, -2}), tangent = unit({2, 1, 2});
    const double sine = 0.5, cosine = std::sqrt(0.75);
    const Doubles incident = sumOf(scaleBy(tangent, sine), scaleBy(normal, -cosine));
    const double refractedSine = eta * sine;
    const Doubles expected = sumOf(scaleBy(tangent, refractedSine),
                                   scaleBy(normal, -std::sqrt(1 - refractedSine * refractedSine)));
    expectNear(
        refract(makeVariable("i", incident), makeVariable("n", normal), makeVariable("eta", eta)),
        expected);
  }
}

TEST_F(AlgebraTest, RefractIsZeroUnderTotalReflection) {
  const Doubles incident{0.9, -std::sqrt(1 - 0.81)};
  expectNear(
      refract(makeVariable("i", incident), makeVariable("n", {0, 1}), makeVariable("eta", 1.5)),
      Doubles{0, 0});
}

TEST_F(AlgebraTest, FaceforwardPointsTheNormalAgainstTheLight) {
  const Value normal = makeVariable("n", {1, 2, 3}), up = makeVariable("up", {0, 0, 1}),
              down = makeVariable("down", {0, 0, -1}), across = makeVariable("across", {1, 0, 0});
  expectNear(faceforward(normal, down, up), Doubles{1, 2, 3});
  expectNear(faceforward(normal, up, up), Doubles{-1, -2, -3});
  expectNear(faceforward(normal, across, up), Doubles{-1, -2, -3});
}

// GLSL: t = clamp((x - low) / (high - low), 0, 1), then t * t * (3 - 2 t).
TEST_F(AlgebraTest, SmoothstepAppliesPerComponent) {
  const Value x = makeVariable("x", {0, 1, 2, 3});
  expectNear(smoothstep(makeVariable("low", 1.0), makeVariable("high", 3.0), x),
             Doubles{0, 0, 0.5, 1});
  expectNear(smoothstep(makeVariable("lows", {0, 0, 0, 0}), makeVariable("highs", {1, 2, 4, 8}), x),
             Doubles{0, 0.5, 0.5, 9.0 / 64 * (3 - 0.75)});
  expectNear(smoothstep(makeVariable("down", 3.0), makeVariable("up", 1.0), x),
             Doubles{1, 1, 0.5, 0});
}

TEST_F(AlgebraTest, OperationsApplyPerComponentAndANumberAppliesToEach) {
  const Value v = makeVariable("v", {1, 2, 4}), w = makeVariable("w", {8, 2, 2});
  const Value two = makeVariable("two", 2.0);
  expectNear(v + w, Doubles{9, 4, 6});
  expectNear(v - w, Doubles{-7, 0, 2});
  expectNear(v * w, Doubles{8, 4, 8});
  expectNear(w / v, Doubles{8, 1, 0.5});
  expectNear(-v, Doubles{-1, -2, -4});
  expectNear(two * v, Doubles{2, 4, 8});
  expectNear(two / v, Doubles{2, 1, 0.5});
  expectNear(two - two, Doubles{0});
}

// Returns the values of a nonlinear function of one point, in doubles.
Doubles sample(const Doubles& p) {
  return {std::sin(p[0]) * p[1], p[0] * p[0] * p[2], std::exp(p[1] - p[2]), p[0] + p[1] * p[2]};
}

TEST_F(AlgebraTest, JacobiansHaveAColumnForEachInput) {
  const Doubles point{0.4, -0.7, 1.2};
  const Value p = makeVariable("p", point);
  const Expression components[] = {sin(p[0]) * p[1], p[0] * p[0] * p[2], exp(p[1] - p[2]),
                                   p[0] + p[1] * p[2]};
  const Value f = fill(graph, vectorOf(4), [&](int i) { return components[i]; });
  expectNear(f, sample(point));

  Matrix expected;
  constexpr double step = 1e-6;
  for (std::size_t column = 0; column < 3; ++column) {
    Doubles above = point, below = point;
    above[column] += step;
    below[column] -= step;
    expected.push_back(scaleBy(sumOf(sample(above), scaleBy(sample(below), -1)), 1 / (2 * step)));
  }
  const Value found = jacobian(differentiator, f, p);
  EXPECT_EQ(found.shape(), matrixOf(3, 4));
  expectNear(found, expected, 1e-9);
  expectNear(derivative(differentiator, f, p[1]), expected[1], 1e-9);
  expectNear(gradient(differentiator, f[2], p),
             Doubles{expected[0][2], expected[1][2], expected[2][2]}, 1e-9);
  EXPECT_EQ(gradient(differentiator, f[2], p).shape(), vectorOf(3));
}

// The branch that is not taken contains the root of a negative number.
TEST_F(AlgebraTest, TheDerivativeOfRefractIsZeroUnderTotalReflection) {
  const Value incident = makeVariable("i", {0.9, -std::sqrt(1 - 0.81)});
  const Value refracted = refract(incident, makeVariable("n", {0, 1}), makeVariable("eta", 1.5));
  expectNear(derivative(differentiator, refracted, incident[0]), Doubles{0, 0});
}

// d(M^-1) = -M^-1 dM M^-1, where dM is the unit matrix.
TEST_F(AlgebraTest, DifferentiatesAnInverse) {
  const Expression t = makeVariable("t", 0.3);
  const Doubles entries = {2, 0.5, -1, 0.3, 3, 0.7, 1, -0.4, 4};
  Value m = makeVariable("m", matrixOf(3, 3), entries);
  for (int i = 0; i < 3; ++i) m.set(i * 4, (m[i * 4] + t).id);
  const Value slope = derivative(differentiator, inverse(m), t);
  const Value expected = -multiply(inverse(m), inverse(m));
  expectNear(slope, evaluateComponents(expected), 1e-12);
}

}  // namespace
}  // namespace warpjet
