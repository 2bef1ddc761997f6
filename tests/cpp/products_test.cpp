// The product of a host's vector and a matrix is written as a product if that is shorter than the
// sums of its components. The expected code is what a person would write.
#include "emit/products.hpp"

#include <gtest/gtest.h>

#include "algebra/vectors.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

class ProductsTest : public testing::Test {
 protected:
  Graph graph;
  Value p = vector3(graph, "p"), q = vector3(graph, "q");
  Expression a = scalar(graph, "a"), b = scalar(graph, "b"), c = scalar(graph, "c");

  // Returns three sums: `columns` has the factors of the first one, then those of the second and
  // third.
  Value times(const std::array<Expression, 9>& columns) {
    return fill(graph, vectorOf(3), [&](int i) {
      return columns[3 * i] * p[0] + columns[3 * i + 1] * p[1] + columns[3 * i + 2] * p[2];
    });
  }

  std::string unitText(const Value& v, const Dialect& dialect = glsl300) {
    return emit(graph, dialect, std::vector{result("y", normalize(v))}).code;
  }
  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
  }
  // Returns true if the code contains a matrix.
  bool isProduct(const Value& v) { return has(unitText(v), "mat3("); }
};

TEST_F(ProductsTest, AreWrittenAsVectorTimesMatrix) {
  const Value v = times({a, b, c, b, c, a * b, c, a, b * c});
  EXPECT_TRUE(has(unitText(v), "  vec3 t0 = p * mat3(a, b, c, b, c, a * b, c, a, b * c);\n"));
  EXPECT_TRUE(
      has(unitText(v, wgsl), "  let t0 = p * mat3x3f(a, b, c, b, c, a * b, c, a, b * c);\n"));
}

TEST_F(ProductsTest, MayHaveNegatedTerms) {
  const Value v = fill(graph, vectorOf(3), [&](int i) {
    if (i == 0) return a * p[0] - (b * p[1] - c * p[2]);
    if (i == 1) return p[0] * (a * b) - p[1] * c - p[2] * (b - c);
    return -(a * p[2]) - (p[1] * (b * c) - p[0] * (a + b));
  });
  EXPECT_TRUE(has(unitText(v), "p * mat3(a, -b, c, a * b, -c, -(b - c), a + b, -(b * c), -a);\n"))
      << unitText(v);
}

// If one product is missing, the sums are shorter. If all entries are cofactors, cross products are
// shorter.
TEST_F(ProductsTest, AreWrittenOnlyIfTheCodeIsShorter) {
  const Expression zero{&graph, graph.constant(0)};
  EXPECT_FALSE(isProduct(times({a, b, c, b, c, a, c, zero, b})));
  const Value u = q * a, w = q + b, s = q * q + c;
  const Value x = cross(u, w), y = cross(w, s), z = cross(s, u);
  EXPECT_FALSE(isProduct(times({x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]})));
}

TEST_F(ProductsTest, MultiplyOnlyOneVector) {
  const std::array<Expression, 9> entries{a, b, c, b, c, a * b, c, a, b * c};
  const Value v = times(entries);
  Value other = v, twice = v, constant = v;
  other.set(0, 2, a * q[0] + b * p[1] + c * p[2]);
  twice.set(0, 2, a * p[0] + b * p[1] * c + a * b * p[1]);
  constant.set(0, 2, v[2] + 1.0);
  EXPECT_TRUE(isProduct(v));
  EXPECT_FALSE(isProduct(other));
  EXPECT_FALSE(isProduct(twice));
  EXPECT_FALSE(isProduct(constant));
}

// A term that another statement or a result reads has a name; a matrix product couldn't use that.
TEST_F(ProductsTest, DoNotUseTermsThatAreReadElsewhere) {
  const Value v = times({a, b, c, b, c, a * b, c, a, b * c});
  const Value shared = normalize(v) + a * p[0];
  EXPECT_FALSE(has(emit(graph, glsl300, std::vector{result("y", shared)}).code, "mat3("));
  const std::vector results{result("y", normalize(v)), result("term", Value(a * p[0]))};
  EXPECT_FALSE(has(emit(graph, glsl300, results).code, "mat3("));
}

}  // namespace
}  // namespace warpjet
