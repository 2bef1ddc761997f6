// Compares matrices of nodes with plain double arithmetic that uses other methods: sums over
// permutations for determinants, elimination for inverses, a basis in which a rotation is planar.
#include <gtest/gtest.h>

#include "algebra_support.hpp"

namespace warpjet {
namespace {

// Computes a determinant by its definition: the sum, over all permutations, of the sign times the
// product of the entries.
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

// Inverts by Gauss-Jordan elimination, with the largest pivots.
Matrix inverseByElimination(Matrix m) {
  const std::size_t n = m.size();
  Matrix inverted(n, Doubles(n));
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

TEST_F(AlgebraTest, ComponentsAreInColumnMajorOrder) {
  const Value m = makeVariable("m", matrixOf(2, 3), {1, 2, 3, 4, 5, 6});
  expectNear(m.column(1), Doubles{4, 5, 6});
  expectNear(m.row(1), Doubles{2, 5});
  expectNear(m.at(1, 2), Doubles{6});
  expectNear(transpose(m), Doubles{1, 4, 2, 5, 3, 6});
  EXPECT_EQ(transpose(m).shape(), matrixOf(3, 2));
}

TEST_F(AlgebraTest, MultipliesMatricesOfAllSizes) {
  for (int rows = 2; rows <= 4; ++rows) {
    for (int inner = 2; inner <= 4; ++inner) {
      for (int columns = 2; columns <= 4; ++columns) {
        const Shape left = matrixOf(inner, rows), right = matrixOf(columns, inner);
        const Doubles a = randomNumbers(left.size()), b = randomNumbers(right.size());
        Matrix expected(columns, Doubles(rows));
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
  const Value column = multiply(m, makeVariable("v", {10, 100}));
  EXPECT_EQ(column.shape(), vectorOf(3));
  expectNear(column, Doubles{410, 520, 630});
  const Value row = multiply(makeVariable("w", {1, 10, 100}), m);
  EXPECT_EQ(row.shape(), vectorOf(2));
  expectNear(row, Doubles{321, 654});
}

TEST_F(AlgebraTest, DeterminantsMatchTheSumOverPermutations) {
  for (int size = 2; size <= 4; ++size) {
    for (int i = 0; i < 20; ++i) {
      const Doubles m = randomNumbers(size * size);
      expectNear(determinant(makeVariable("m", matrixOf(size, size), m)),
                 Doubles{determinantByPermutations(toMatrix(m, matrixOf(size, size)))}, 1e-12);
    }
  }
}

TEST_F(AlgebraTest, InversesMatchGaussJordanElimination) {
  for (int size = 2; size <= 4; ++size) {
    const Shape shape = matrixOf(size, size);
    for (int i = 0; i < 20; ++i) {
      const Doubles m = randomNumbers(size * size);
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

// Without sharing, the adjugate's 3x3 minors take 16 * 9 products and the determinant 40 more. With
// sharing, the 12 minors of rows (0, 1) and (2, 3) take 2 products each: 24; the 16 cofactors take
// 3 more each: 48; and the determinant takes 4. Dividing by the determinant takes one quotient per
// entry.
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
  expectNear(diagonal(3, makeVariable("x", 7.0)), Doubles{7, 0, 0, 0, 7, 0, 0, 0, 7});
}

// Rotates in a basis of the axis and two directions perpendicular to it, where a rotation is
// planar.
Doubles rotateInBasis(const Doubles& v, const Doubles& axis, double angle) {
  const Doubles w = unit(axis);
  const Doubles a = unit(crossOf(w, std::abs(w[0]) < 0.9 ? Doubles{1, 0, 0} : Doubles{0, 1, 0}));
  const Doubles b = crossOf(w, a);
  const double x = dotOf(v, a), y = dotOf(v, b);
  const double c = std::cos(angle), s = std::sin(angle);
  return sumOf(scaleBy(w, dotOf(v, w)),
               sumOf(scaleBy(a, c * x - s * y), scaleBy(b, s * x + c * y)));
}

TEST_F(AlgebraTest, QuarterTurnsAreCounterclockwise) {
  const Expression quarter = makeVariable("quarter", M_PI / 2);
  const Value x = makeVariable("x", {1, 0, 0}), y = makeVariable("y", {0, 1, 0}),
              z = makeVariable("z", {0, 0, 1});
  expectNear(multiply(rotationAbout(0, quarter), y), Doubles{0, 0, 1});
  expectNear(multiply(rotationAbout(1, quarter), z), Doubles{1, 0, 0});
  expectNear(multiply(rotationAbout(2, quarter), x), Doubles{0, 1, 0});
}

TEST_F(AlgebraTest, RotationsRotateEveryVector) {
  for (int i = 0; i < 20; ++i) {
    const Doubles axis = randomNumbers(3), v = randomNumbers(3);
    const double angle = 3 * randomNumbers(1)[0];
    const Value vector = makeVariable("v", v);
    const Expression theta = makeVariable("angle", angle);
    expectNear(multiply(rotationAbout(makeVariable("axis", axis), theta), vector),
               rotateInBasis(v, axis, angle));
    for (int k = 0; k < 3; ++k) {
      Doubles unitAxis(3);
      unitAxis[k] = 1;
      expectNear(multiply(rotationAbout(k, theta), vector), rotateInBasis(v, unitAxis, angle));
    }
  }
}

}  // namespace
}  // namespace warpjet
