// Compares vectors and matrices of nodes with plain double arithmetic that uses other methods: sums
// over permutations for determinants, elimination for inverses, a basis in which a rotation is
// planar.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "algebra/derivatives.hpp"
#include "algebra/matrices.hpp"
#include "algebra/vectors.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

using Numbers = std::vector<double>;

// A plain matrix: m[column][row], as in GLSL.
using Matrix = std::vector<Numbers>;

Matrix toMatrix(const Numbers& components, Shape shape) {
  Matrix m(shape.columns, Numbers(shape.rows));
  for (int i = 0; i < shape.size(); ++i) m[i / shape.rows][i % shape.rows] = components[i];
  return m;
}

// The definition: the sum over all permutations of the sign times the product along each.
double determinantByPermutations(const Matrix& m) {
  std::vector<int> p(m.size());
  std::iota(p.begin(), p.end(), 0);
  double total = 0;
  do {
    double term = 1;
    for (std::size_t i = 0; i < p.size(); ++i) {
      term *= m[i][p[i]];
      for (std::size_t k = 0; k < i; ++k) term *= p[k] > p[i] ? -1 : 1;
    }
    total += term;
  } while (std::next_permutation(p.begin(), p.end()));
  return total;
}

// Gauss-Jordan elimination, with the largest pivot.
Matrix inverseByElimination(Matrix m) {
  const std::size_t n = m.size();
  Matrix inverted(n, Numbers(n));
  for (std::size_t i = 0; i < n; ++i) inverted[i][i] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t k = i; k < n; ++k)
      pivot = std::abs(m[k][i]) > std::abs(m[pivot][i]) ? k : pivot;
    std::swap(m[i], m[pivot]);
    std::swap(inverted[i], inverted[pivot]);
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double factor = m[k][i] / m[i][i];
      for (std::size_t j = 0; j < n; ++j) {
        m[k][j] -= factor * m[i][j];
        inverted[k][j] -= factor * inverted[i][j];
      }
    }
    const double scale = m[i][i];
    for (std::size_t j = 0; j < n; ++j) {
      m[i][j] /= scale;
      inverted[i][j] /= scale;
    }
  }
  return inverted;
}

double dotOf(const Numbers& a, const Numbers& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

Numbers crossOf(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Numbers scaleBy(Numbers v, double factor) {
  for (double& x : v) x *= factor;
  return v;
}

Numbers sumOf(const Numbers& a, const Numbers& b) {
  Numbers total = a;
  for (std::size_t i = 0; i < b.size(); ++i) total[i] += b[i];
  return total;
}

Numbers unit(const Numbers& v) { return scaleBy(v, 1 / std::sqrt(dotOf(v, v))); }

class AlgebraTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Inputs inputs;
  std::mt19937 random{1};

  // A variable with a value per component.
  Value makeVariable(const std::string& name, Shape shape, const Numbers& components) {
    const Value value = variable(graph, name, shape);
    for (int i = 0; i < shape.size(); ++i) inputs[value[i].id] = components[i];
    return value;
  }
  Value makeVariable(const std::string& name, const Numbers& components) {
    return makeVariable(name, vectorOf(static_cast<int>(components.size())), components);
  }
  Expression makeVariable(const std::string& name, double number) {
    return makeVariable(name, oneNumber, {number})[0];
  }

  Numbers randomNumbers(int count) {
    Numbers numbers;
    for (int i = 0; i < count; ++i)
      numbers.push_back(std::uniform_real_distribution(-2.0, 2.0)(random));
    return numbers;
  }

  Numbers evaluateComponents(const Value& value) {
    Numbers numbers;
    for (const NodeId id : value.nodes()) numbers.push_back(evaluateNode(graph, id, inputs));
    return numbers;
  }

  void expectNear(const Value& value, const Numbers& expected, double tolerance = 1e-13) {
    const Numbers found = evaluateComponents(value);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], tolerance * std::max(1.0, std::abs(expected[i])))
          << "component " << i;
  }
  void expectNear(const Value& value, const Matrix& expected, double tolerance = 1e-13) {
    Numbers components;
    for (const Numbers& column : expected)
      components.insert(components.end(), column.begin(), column.end());
    expectNear(value, components, tolerance);
  }
};

// --- vectors

TEST_F(AlgebraTest, ComputesSumAndDot) {
  const Value a = makeVariable("a", {1, 2, 3, 4}), b = makeVariable("b", {5, -6, 7, 8});
  expectNear(sum(a), Numbers{10});
  expectNear(dot(a, b), Numbers{5 - 12 + 21 + 32});
}

TEST_F(AlgebraTest, CrossIsRightHandedAndPerpendicular) {
  const Value x = makeVariable("x", {1, 0, 0}), y = makeVariable("y", {0, 1, 0});
  expectNear(cross(x, y), Numbers{0, 0, 1});
  expectNear(cross(y, x), Numbers{0, 0, -1});
  expectNear(cross(makeVariable("a", {1, 2, 3}), makeVariable("b", {4, 5, 6})), Numbers{-3, 6, -3});
}

TEST_F(AlgebraTest, ComputesLengthAndNormalize) {
  expectNear(length(makeVariable("a", {3, 4})), Numbers{5});
  expectNear(length(makeVariable("b", {2, 3, 6})), Numbers{7});
  expectNear(length(makeVariable("c", {1, -1, 1, -1})), Numbers{2});
  expectNear(normalize(makeVariable("a", {3, 4})), Numbers{0.6, 0.8});
  expectNear(normalize(makeVariable("zero", {0, 0, 0})), Numbers{0, 0, 0});
}

TEST_F(AlgebraTest, ReflectMirrorsAtTheSurface) {
  expectNear(reflect(makeVariable("i", {1, -1}), makeVariable("n", {0, 1})), Numbers{1, 1});
  const Numbers incident{0.3, -0.7, 0.2}, normal = unit({1, 2, -2});
  const double along = dotOf(incident, normal);
  expectNear(reflect(makeVariable("i3", incident), makeVariable("n3", normal)),
             sumOf(incident, scaleBy(normal, -2 * along)));
}

// Snell's law: the part along the surface is eta times as long, and the direction has unit length.
TEST_F(AlgebraTest, RefractFollowsSnell) {
  for (const double eta : {0.6, 1.0, 1.3}) {
    const Numbers normal = unit({1, 2, -2}), tangent = unit({2, 1, 2});
    const double sine = 0.5, cosine = std::sqrt(0.75);
    const Numbers incident = sumOf(scaleBy(tangent, sine), scaleBy(normal, -cosine));
    const double behind = eta * sine;
    const Numbers expected =
        sumOf(scaleBy(tangent, behind), scaleBy(normal, -std::sqrt(1 - behind * behind)));
    expectNear(
        refract(makeVariable("i", incident), makeVariable("n", normal), makeVariable("eta", eta)),
        expected);
  }
}

TEST_F(AlgebraTest, RefractIsZeroUnderTotalReflection) {
  const Numbers incident{0.9, -std::sqrt(1 - 0.81)};
  expectNear(
      refract(makeVariable("i", incident), makeVariable("n", {0, 1}), makeVariable("eta", 1.5)),
      Numbers{0, 0});
}

TEST_F(AlgebraTest, FaceforwardPointsTheNormalAgainstTheLight) {
  const Value normal = makeVariable("n", {1, 2, 3}), up = makeVariable("up", {0, 0, 1}),
              down = makeVariable("down", {0, 0, -1}), across = makeVariable("across", {1, 0, 0});
  expectNear(faceforward(normal, down, up), Numbers{1, 2, 3});
  expectNear(faceforward(normal, up, up), Numbers{-1, -2, -3});
  expectNear(faceforward(normal, across, up), Numbers{-1, -2, -3});
}

// GLSL: t = clamp((x - low) / (high - low), 0, 1), then t * t * (3 - 2 t).
TEST_F(AlgebraTest, SmoothstepAppliesPerComponent) {
  const Value x = makeVariable("x", {0, 1, 2, 3});
  expectNear(smoothstep(makeVariable("low", 1.0), makeVariable("high", 3.0), x),
             Numbers{0, 0, 0.5, 1});
  expectNear(smoothstep(makeVariable("lows", {0, 0, 0, 0}), makeVariable("highs", {1, 2, 4, 8}), x),
             Numbers{0, 0.5, 0.5, 9.0 / 64 * (3 - 0.75)});
  expectNear(smoothstep(makeVariable("down", 3.0), makeVariable("up", 1.0), x),
             Numbers{1, 1, 0.5, 0});
}

TEST_F(AlgebraTest, OperationsApplyPerComponentAndANumberAppliesToEach) {
  const Value v = makeVariable("v", {1, 2, 4}), w = makeVariable("w", {8, 2, 2});
  const Value two = makeVariable("two", 2.0);
  expectNear(v + w, Numbers{9, 4, 6});
  expectNear(v - w, Numbers{-7, 0, 2});
  expectNear(v * w, Numbers{8, 4, 8});
  expectNear(w / v, Numbers{8, 1, 0.5});
  expectNear(-v, Numbers{-1, -2, -4});
  expectNear(two * v, Numbers{2, 4, 8});
  expectNear(two / v, Numbers{2, 1, 0.5});
  expectNear(two - two, Numbers{0});
}

// --- matrices

TEST_F(AlgebraTest, ComponentsAreInColumnMajorOrder) {
  const Value m = makeVariable("m", matrixOf(2, 3), {1, 2, 3, 4, 5, 6});
  expectNear(m.column(1), Numbers{4, 5, 6});
  expectNear(m.row(1), Numbers{2, 5});
  expectNear(m.at(1, 2), Numbers{6});
  expectNear(transpose(m), Numbers{1, 4, 2, 5, 3, 6});
  EXPECT_EQ(transpose(m).shape(), matrixOf(3, 2));
}

TEST_F(AlgebraTest, MultipliesMatricesOfAllSizes) {
  for (int rows = 2; rows <= 4; ++rows) {
    for (int inner = 2; inner <= 4; ++inner) {
      for (int columns = 2; columns <= 4; ++columns) {
        const Shape left = matrixOf(inner, rows), right = matrixOf(columns, inner);
        const Numbers a = randomNumbers(left.size()), b = randomNumbers(right.size());
        Matrix expected(columns, Numbers(rows));
        for (int c = 0; c < columns; ++c) {
          for (int k = 0; k < inner; ++k) {
            for (int r = 0; r < rows; ++r)
              expected[c][r] += toMatrix(a, left)[k][r] * toMatrix(b, right)[c][k];
          }
        }
        const Value product = multiply(makeVariable("a", left, a), makeVariable("b", right, b));
        EXPECT_EQ(product.shape(), matrixOf(columns, rows));
        expectNear(product, expected);
      }
    }
  }
}

TEST_F(AlgebraTest, AVectorOnTheRightIsAColumnAndOnTheLeftARow) {
  const Value m = makeVariable("m", matrixOf(2, 3), {1, 2, 3, 4, 5, 6});
  const Value behind = multiply(m, makeVariable("v", {10, 100}));
  EXPECT_EQ(behind.shape(), vectorOf(3));
  expectNear(behind, Numbers{410, 520, 630});
  const Value before = multiply(makeVariable("w", {1, 10, 100}), m);
  EXPECT_EQ(before.shape(), vectorOf(2));
  expectNear(before, Numbers{321, 654});
}

TEST_F(AlgebraTest, DeterminantsMatchTheSumOverPermutations) {
  for (int size = 2; size <= 4; ++size) {
    for (int i = 0; i < 20; ++i) {
      const Numbers m = randomNumbers(size * size);
      expectNear(determinant(makeVariable("m", matrixOf(size, size), m)),
                 Numbers{determinantByPermutations(toMatrix(m, matrixOf(size, size)))}, 1e-12);
    }
  }
}

TEST_F(AlgebraTest, InversesMatchGaussJordanElimination) {
  for (int size = 2; size <= 4; ++size) {
    const Shape shape = matrixOf(size, size);
    for (int i = 0; i < 20; ++i) {
      const Numbers m = randomNumbers(size * size);
      if (std::abs(determinantByPermutations(toMatrix(m, shape))) < 0.1) continue;
      expectNear(inverse(makeVariable("m", shape, m)), inverseByElimination(toMatrix(m, shape)),
                 1e-11);
    }
  }
}

TEST_F(AlgebraTest, ASingularMatrixHasAnInfiniteInverse) {
  const Value m = makeVariable("m", matrixOf(2, 2), {1, 2, 2, 4});
  for (const double entry : evaluateComponents(inverse(m))) EXPECT_TRUE(std::isinf(entry));
}

int countOf(const Graph& graph, const Value& roots, std::string_view row) {
  int count = 0;
  for (const NodeId id : reachable(graph, roots.nodes())) count += graph.is(id, rowNamed(row));
  return count;
}

// Written out, an adjugate of 3x3 minors has 16 * 9 products, the determinant 40 more. The minors
// of rows (0, 1) and (2, 3) are shared: 12 of 2 products each make 24, the 16 cofactors take 3 more
// each, 48, and the determinant takes 4. The scale is one quotient per entry.
TEST_F(AlgebraTest, TheInverseOfAMat4SharesItsMinors) {
  const Value inverted = inverse(variable(graph, "m", matrixOf(4, 4)));
  EXPECT_EQ(countOf(graph, inverted, "mult"), 24 + 48 + 4);
  EXPECT_EQ(countOf(graph, inverted, "div"), 16);
}

TEST_F(AlgebraTest, ZerosOfAMatrixNeedNoOperations) {
  Value m = diagonal(4, {&graph, graph.constant(1)});
  const Value shift = variable(graph, "shift", vectorOf(3));
  for (int i = 0; i < 3; ++i) m.set(12 + i, shift[i].id);
  EXPECT_TRUE(graph.isConstant(determinant(m).id, 1));
  const Value back = inverse(m);
  EXPECT_EQ(countOf(graph, back, "mult"), 0) << "the inverse of a translation is a translation";
  for (int i = 0; i < 3; ++i) EXPECT_EQ(back[12 + i].id, (-shift[i]).id);
}

TEST_F(AlgebraTest, MakesDiagonalMatrices) {
  expectNear(diagonal(3, makeVariable("x", 7.0)), Numbers{7, 0, 0, 0, 7, 0, 0, 0, 7});
}

// In a basis of the axis and two perpendicular directions, a rotation is planar.
Numbers rotateInBasis(const Numbers& v, const Numbers& axis, double angle) {
  const Numbers w = unit(axis);
  const Numbers a = unit(crossOf(w, std::abs(w[0]) < 0.9 ? Numbers{1, 0, 0} : Numbers{0, 1, 0}));
  const Numbers b = crossOf(w, a);
  const double x = dotOf(v, a), y = dotOf(v, b);
  const double c = std::cos(angle), s = std::sin(angle);
  return sumOf(scaleBy(w, dotOf(v, w)),
               sumOf(scaleBy(a, c * x - s * y), scaleBy(b, s * x + c * y)));
}

TEST_F(AlgebraTest, QuarterTurnsAreCounterclockwise) {
  const Expression quarter = makeVariable("quarter", M_PI / 2);
  const Value x = makeVariable("x", {1, 0, 0}), y = makeVariable("y", {0, 1, 0}),
              z = makeVariable("z", {0, 0, 1});
  expectNear(multiply(rotationAbout(0, quarter), y), Numbers{0, 0, 1});
  expectNear(multiply(rotationAbout(1, quarter), z), Numbers{1, 0, 0});
  expectNear(multiply(rotationAbout(2, quarter), x), Numbers{0, 1, 0});
}

TEST_F(AlgebraTest, RotationsRotateEveryVector) {
  for (int i = 0; i < 20; ++i) {
    const Numbers axis = randomNumbers(3), v = randomNumbers(3);
    const double angle = 3 * randomNumbers(1)[0];
    const Value turned = makeVariable("v", v);
    const Expression by = makeVariable("angle", angle);
    expectNear(multiply(rotationAbout(makeVariable("axis", axis), by), turned),
               rotateInBasis(v, axis, angle));
    for (int k = 0; k < 3; ++k) {
      Numbers unitAxis(3);
      unitAxis[k] = 1;
      expectNear(multiply(rotationAbout(k, by), turned), rotateInBasis(v, unitAxis, angle));
    }
  }
}

// --- derivatives

// A function of two points with terms of all kinds, as plain numbers.
Numbers sample(const Numbers& p) {
  return {std::sin(p[0]) * p[1], p[0] * p[0] * p[2], std::exp(p[1] - p[2]), p[0] + p[1] * p[2]};
}

TEST_F(AlgebraTest, JacobiansHaveAColumnForEachInput) {
  const Numbers at{0.4, -0.7, 1.2};
  const Value p = makeVariable("p", at);
  const Expression components[] = {sin(p[0]) * p[1], p[0] * p[0] * p[2], exp(p[1] - p[2]),
                                   p[0] + p[1] * p[2]};
  const Value f = fill(graph, vectorOf(4), [&](int i) { return components[i]; });
  expectNear(f, sample(at));

  Matrix expected;
  constexpr double step = 1e-6;
  for (std::size_t column = 0; column < 3; ++column) {
    Numbers above = at, below = at;
    above[column] += step;
    below[column] -= step;
    expected.push_back(scaleBy(sumOf(sample(above), scaleBy(sample(below), -1)), 1 / (2 * step)));
  }
  const Value found = jacobian(differentiator, f, p);
  EXPECT_EQ(found.shape(), matrixOf(3, 4));
  expectNear(found, expected, 1e-9);
  expectNear(derivative(differentiator, f, p[1]), expected[1], 1e-9);
  expectNear(gradient(differentiator, f[2], p),
             Numbers{expected[0][2], expected[1][2], expected[2][2]}, 1e-9);
  EXPECT_EQ(gradient(differentiator, f[2], p).shape(), vectorOf(3));
}

// The root of a negative number remains in the branch that is not taken.
TEST_F(AlgebraTest, TheDerivativeOfRefractIsZeroUnderTotalReflection) {
  const Value incident = makeVariable("i", {0.9, -std::sqrt(1 - 0.81)});
  const Value turned = refract(incident, makeVariable("n", {0, 1}), makeVariable("eta", 1.5));
  expectNear(derivative(differentiator, turned, incident[0]), Numbers{0, 0});
}

// d(M^-1) = -M^-1 dM M^-1, with dM the unit matrix.
TEST_F(AlgebraTest, DifferentiatesAnInverse) {
  const Expression t = makeVariable("t", 0.3);
  const Numbers entries = {2, 0.5, -1, 0.3, 3, 0.7, 1, -0.4, 4};
  Value m = makeVariable("m", matrixOf(3, 3), entries);
  for (int i = 0; i < 3; ++i) m.set(i * 4, (m[i * 4] + t).id);
  const Value slope = derivative(differentiator, inverse(m), t);
  const Value expected = -multiply(inverse(m), inverse(m));
  expectNear(slope, evaluateComponents(expected), 1e-12);
}

}  // namespace
}  // namespace warpjet
