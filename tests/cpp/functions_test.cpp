// Functions of the library: the numbering of their derivatives, the derivatives, their code, and
// inlining. The function here is x² y + s, whose derivatives are easy to compute by hand.
#include "emit/functions.hpp"

#include <gtest/gtest.h>

#include "functions/library.hpp"
#include "graph/multi_index.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

TEST(MultiIndices, AreSortedByOrderAndThenByVariables) {
  const MultiIndices indices(2, 2);  // f, fx, fy, fxx, fxy, fyy
  ASSERT_EQ(indices.count(), 6);
  EXPECT_EQ(indices.origin(4), 1);
  EXPECT_EQ(indices.lastVariable(4), 1);
}

TEST(MultiIndices, DoNotDependOnTheOrderOfDifferentiation) {
  MultiIndices indices(3, 1);
  const int x = indices.derivative(0, 0), y = indices.derivative(0, 1),
            z = indices.derivative(0, 2);
  EXPECT_EQ((std::array{x, y, z}), (std::array{1, 2, 3}));
  EXPECT_EQ(indices.derivative(x, 1), indices.derivative(y, 0));
  EXPECT_EQ(indices.derivative(indices.derivative(z, 0), 1),
            indices.derivative(indices.derivative(y, 2), 0));
}

TEST(MultiIndices, CountsAndOrdersAreConsistent) {
  for (int variables = 0; variables <= 4; ++variables) {
    for (int order = 0; order <= 3; ++order) {
      const int count = MultiIndices(variables, order).count();
      EXPECT_EQ(MultiIndices::countUpTo(variables, order), count);
      if (variables > 0) {
        EXPECT_EQ(MultiIndices::orderOf(variables, count - 1), order);
        EXPECT_EQ(MultiIndices::orderOf(variables, count), order + 1);
      }
    }
  }
}

const Definition square{{"warpjetSquare", 3, 1, 2},
                        [](Library&, std::uint32_t factor, const Numbers& a) {
                          return Numbers{a[0] * a[0] * a[1] * double(factor) + a[2]};
                        },
                        1};

class FunctionsTest : public testing::Test {
 protected:
  std::string declarations(const Dialect& dialect, std::span<const Output> outputs) {
    Declarations written(dialect, library);
    written.add(graph, emit(graph, dialect, outputs));
    return written.text();
  }

  Graph graph;
  Library library;
  Differentiator differentiator{graph};
  Expression x = scalar(graph, "x"), y = scalar(graph, "y");
  Expression called = library.call(square, {x * 3.0, y, y})[0];

  Expression derivative(Expression f, Expression variable) {
    return {&graph, differentiator.derivative(f.id, variable.id)};
  }

  // Returns the value at x = 2 and y = 5, with all calls inlined.
  double value(Expression f) {
    const NodeId root = inlineCalls(graph, library, {&f.id, 1})[0];
    return evaluateNode(graph, root, {{x.id, 2}, {y.id, 5}});
  }
};

TEST_F(FunctionsTest, InliningSubstitutesTheArguments) { EXPECT_EQ(value(called), 36 * 5 + 5); }

TEST_F(FunctionsTest, DerivativesFollowTheChainRule) {
  // 9 x² y + s, where s is y; but a parameter's derivative is treated as zero.
  EXPECT_EQ(value(derivative(called, x)), 18 * 2 * 5);
  EXPECT_EQ(value(derivative(called, y)), 9 * 4);
  EXPECT_EQ(value(derivative(derivative(called, x), y)), 18 * 2);
  EXPECT_EQ(value(derivative(derivative(called, y), x)), 18 * 2);
  EXPECT_EQ(value(derivative(derivative(derivative(called, x), y), x)), 18);
}

TEST_F(FunctionsTest, AllResultsOfACallShareOneStatement) {
  const Output outputs[] = {result("a", called), result("b", derivative(called, x))};
  EXPECT_EQ(emit(graph, glsl300, outputs).code,
            "float a, b;\n"
            "{\n"
            "  vec3 t0 = warpjetSquareGradient(x * 3.0, y, y);\n"
            "  a = t0.x;\n"
            "  b = t0.y * 3.0;\n"
            "}\n");
}

TEST_F(FunctionsTest, AFunctionIsEmittedInEveryLanguage) {
  const Output outputs[] = {result("a", called)};
  EXPECT_EQ(declarations(glsl300, outputs),
            "float warpjetSquare(float x, float y, float seed) {\n"
            "float result;\n"
            "{\n"
            "  result = x * x * y + seed;\n"
            "}\n"
            "return result;\n"
            "}\n");
  EXPECT_EQ(declarations(wgsl, outputs),
            "fn warpjetSquare(x: f32, y: f32, seed: f32) -> f32 {\n"
            "var result: f32;\n"
            "{\n"
            "  result = x * x * y + seed;\n"
            "}\n"
            "return result;\n"
            "}\n");
}

TEST_F(FunctionsTest, SeveralResultsAreReturnedAsAStruct) {
  const Output outputs[] = {result("a", derivative(derivative(called, x), y))};
  EXPECT_EQ(emit(graph, glsl300, outputs).code,
            "float a;\n"
            "{\n"
            "  warpjetSquareHessianResults t0 = warpjetSquareHessian(x * 3.0, y, y);\n"
            "  a = t0.part1.x * 3.0;\n"
            "}\n");
  const std::string glsl = declarations(glsl300, outputs), wgslText = declarations(wgsl, outputs);
  EXPECT_TRUE(
      glsl.starts_with("struct warpjetSquareHessianResults { vec4 part0; vec4 part1; };\n"));
  EXPECT_NE(glsl.find("return warpjetSquareHessianResults(part0, part1);\n"), glsl.npos);
  EXPECT_TRUE(
      wgslText.starts_with("struct warpjetSquareHessianResults { part0: vec4f, part1: vec4f, }\n"));
}

TEST_F(FunctionsTest, AFunctionIsDeclaredAfterThoseItCalls) {
  const Definition twice{{"warpjetTwice", 1, 1, 1},
                         [](Library& inner, std::uint32_t, const Numbers& a) {
                           return Numbers{inner.call(square, {a[0], a[0], a[0]})[0] * 2.0};
                         },
                         0};
  const Expression doubled = library.call(twice, {x})[0];
  const Output outputs[] = {result("a", derivative(doubled, x)), result("b", called)};
  const std::string text = declarations(glsl300, outputs);
  const auto first = text.find("warpjetSquareGradient("),
             second = text.find("warpjetTwiceGradient(");
  EXPECT_LT(first, second);
  EXPECT_NE(second, text.npos);
  EXPECT_EQ(value(derivative(doubled, x)), 2 * 3 * 4) << "2 x³ + 2 s, where s is a parameter";
}

TEST_F(FunctionsTest, AResultThatIsUsedTwiceIsComputedOnce) {
  const Output outputs[] = {result("a", called * called)};
  EXPECT_EQ(emit(graph, glsl300, outputs).code,
            "float a;\n"
            "{\n"
            "  float t0 = warpjetSquare(x * 3.0, y, y);\n"
            "  a = t0 * t0;\n"
            "}\n");
}

}  // namespace
}  // namespace warpjet
