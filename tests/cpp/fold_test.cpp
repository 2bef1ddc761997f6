// Folds: their values and derivatives, compared with loops and hand-written derivatives in double,
// and their code in each language.
#include "functions/fold.hpp"

#include <gtest/gtest.h>

#include "diff/differentiator.hpp"
#include "eval/bounds.hpp"
#include "eval/program.hpp"
#include "functions/library.hpp"
#include "module/module.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

class FoldTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Expression x = scalar(graph, "x");
  Expression y = scalar(graph, "y");

  Expression derivative(Expression f, Expression variable) {
    return {&graph, differentiator.derivative(f.id, variable.id)};
  }
  // Returns the value of f, computed by `evaluate`.
  double at(Expression f, double xValue = 0.3, double yValue = 0.7) {
    Library library;
    Graph copy = graph.copy();
    const std::vector<NodeId> roots = inlineCalls(copy, library, {&f.id, 1});
    const auto compiled = program(copy, roots);
    const double inputs[] = {xValue, yValue};
    double result = 0;
    evaluate(compiled->words, compiled->instructions, inputs, {&result, 1});
    return result;
  }
  // Returns the real part of z after iterating z² + c.
  Expression mandelbrot(std::uint32_t steps) {
    return fold(steps, {x * 0.5, y}, [&](const Numbers& z, Expression) {
      return Numbers{z[0] * z[0] - z[1] * z[1] + x, z[0] * z[1] * 2.0 + y};
    })[0];
  }
};

double mandelbrotByHand(int steps, double x, double y) {
  double a = x * 0.5, b = y;
  for (int i = 0; i < steps; ++i) {
    const double square = a * a - b * b + x;
    b = a * b * 2 + y;
    a = square;
  }
  return a;
}

TEST_F(FoldTest, MatchesALoopInCpp) {
  for (const int steps : {0, 1, 2, 5})
    EXPECT_NEAR(at(mandelbrot(static_cast<std::uint32_t>(steps)), 0.3, 0.7),
                mandelbrotByHand(steps, 0.3, 0.7), 1e-12)
        << steps;
}

TEST_F(FoldTest, PassesTheStepToTheBody) {
  const Expression sum =
      fold(5, {x}, [&](const Numbers& s, Expression i) { return Numbers{s[0] + i * y}; })[0];
  EXPECT_DOUBLE_EQ(at(sum, 1, 2), 1 + (0 + 1 + 2 + 3 + 4) * 2.0);
}

TEST_F(FoldTest, DerivativesMatchFiniteDifferencesOfTheLoop) {
  const Expression f = mandelbrot(4);
  const double h = 1e-5;
  const auto g = [](double a, double b) { return mandelbrotByHand(4, a, b); };
  const Expression fx = derivative(f, x), fy = derivative(f, y);
  EXPECT_NEAR(at(fx), (g(0.3 + h, 0.7) - g(0.3 - h, 0.7)) / (2 * h), 1e-7);
  EXPECT_NEAR(at(fy), (g(0.3, 0.7 + h) - g(0.3, 0.7 - h)) / (2 * h), 1e-7);
  const double k = 1e-3;
  EXPECT_NEAR(
      at(derivative(fx, y)),
      (g(0.3 + k, 0.7 + k) - g(0.3 - k, 0.7 + k) - g(0.3 + k, 0.7 - k) + g(0.3 - k, 0.7 - k)) /
          (4 * k * k),
      1e-3);
  EXPECT_NEAR(at(derivative(fx, x)),
              (g(0.3 + k, 0.7) - 2 * g(0.3, 0.7) + g(0.3 - k, 0.7)) / (k * k), 1e-3);
}

// Computes x³ by repeated multiplication: its derivatives of all orders are known.
TEST_F(FoldTest, HasDerivativesOfEveryOrder) {
  const Expression one{&graph, graph.constant(1)};
  Expression f = fold(3, {one}, [&](const Numbers& s, Expression) { return Numbers{s[0] * x}; })[0];
  const double expected[] = {0.027, 0.27, 1.8, 6, 0};
  for (const double value : expected) {
    EXPECT_NEAR(at(f), value, 1e-12);
    f = derivative(f, x);
  }
}

TEST_F(FoldTest, StatesIndependentOfTheVariableHaveNoDerivative) {
  const Numbers both = fold(3, {x, y}, [&](const Numbers& s, Expression i) {
    return Numbers{s[0] + floor(s[1]) * y, s[1] + i};
  });
  EXPECT_TRUE(graph.isConstant(derivative(both[1], x).id, 0));
  EXPECT_DOUBLE_EQ(at(derivative(both[0], x)), 1);
  EXPECT_DOUBLE_EQ(at(derivative(both[0], y), 0.3, 2.5), 2 + 2 + 3);
}

// The sum over i and k of sin(i x + k y).
TEST_F(FoldTest, FoldsCanBeNested) {
  const Expression zero{&graph, graph.constant(0)};
  const Expression sum = fold(3, {zero}, [&](const Numbers& s, Expression i) {
    return fold(4, {s[0]}, [&](const Numbers& inner, Expression k) {
      return Numbers{inner[0] + sin(i * x + k * y)};
    });
  })[0];
  double value = 0, slope = 0, mixed = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) {
      value += std::sin(i * 0.3 + k * 0.7);
      slope += i * std::cos(i * 0.3 + k * 0.7);
      mixed -= i * k * std::sin(i * 0.3 + k * 0.7);
    }
  }
  EXPECT_NEAR(at(sum), value, 1e-12);
  EXPECT_NEAR(at(derivative(sum, x)), slope, 1e-12);
  EXPECT_NEAR(at(derivative(derivative(sum, x), y)), mixed, 1e-12);
}

TEST_F(FoldTest, AResultCarriesOnlyTheStatesItNeeds) {
  const Numbers both = fold(4, {x, y}, [&](const Numbers& s, Expression) {
    return Numbers{s[0] * 2.0, s[1] + s[0]};
  });
  EXPECT_EQ(graph.states(graph.operand(both[0].id, 0)).size(), 1u);
  EXPECT_EQ(graph.states(graph.operand(both[1].id, 0)).size(), 2u);
}

TEST_F(FoldTest, IsEmittedAsALoopInEachLanguage) {
  const Expression f = mandelbrot(4);
  const char* glsl =
      "float y;\n{\n"
      "  float t0 = x * 0.5;\n"
      "  float t1 = y;\n"
      "  for (int t2 = 0; t2 < 4; t2++) {\n"
      "    float t3 = t0 * t0 - t1 * t1 + x;\n"
      "    float t4 = t0 * t1 * 2.0 + y;\n"
      "    t0 = t3;\n"
      "    t1 = t4;\n"
      "  }\n"
      "  y = t0;\n}\n";
  EXPECT_EQ(code(f, 8, glsl300), glsl);
  EXPECT_EQ(code(f, 8, glsl100), glsl);
  EXPECT_EQ(code(f, 8, wgsl),
            "var y: f32;\n{\n"
            "  var t0 = x * 0.5f;\n"
            "  var t1 = y;\n"
            "  for (var t2 = 0; t2 < 4; t2++) {\n"
            "    let t3 = t0 * t0 - t1 * t1 + x;\n"
            "    let t4 = t0 * t1 * 2.0f + y;\n"
            "    t0 = t3;\n"
            "    t1 = t4;\n"
            "  }\n"
            "  y = t0;\n}\n");
}

// The code for nodes that don't depend on the body's variables is before the loop. Value and
// derivative share a loop.
TEST_F(FoldTest, EmitsANestedLoopWithADerivative) {
  const Expression zero{&graph, graph.constant(0)};
  const Expression sum = fold(3, {zero}, [&](const Numbers& s, Expression i) {
    return fold(4, {s[0]}, [&](const Numbers& inner, Expression k) {
      return Numbers{inner[0] + sin(i * x + k * y) * sin(x * y)};
    });
  })[0];
  const Value all = fill(graph, vectorOf(2), [&](int i) { return i ? derivative(sum, x) : sum; });
  EXPECT_EQ(emit(graph, wgsl, std::vector{result("r", all)}).code,
            "var r: vec2f;\n{\n"
            "  let t0 = x * y;\n"
            "  let t1 = sin(t0);\n"
            "  let t2 = cos(t0) * y;\n"
            "  var t3 = 0.0f;\n"
            "  var t4 = 0.0f;\n"
            "  for (var t5 = 0; t5 < 3; t5++) {\n"
            "    let t6 = f32(t5);\n"
            "    let t7 = t6 * x;\n"
            "    var t8 = t3;\n"
            "    var t9 = t4;\n"
            "    for (var t10 = 0; t10 < 4; t10++) {\n"
            "      let t11 = f32(t10);\n"
            "      let t12 = t7 + t11 * y;\n"
            "      let t13 = sin(t12);\n"
            "      let t14 = t9 + (t1 * (cos(t12) * t6) + t13 * t2);\n"
            "      let t15 = t8 + t13 * t1;\n"
            "      t8 = t15;\n"
            "      t9 = t14;\n"
            "    }\n"
            "    t3 = t8;\n"
            "    t4 = t9;\n"
            "  }\n"
            "  r = vec2f(t3, t4);\n}\n");
}

TEST_F(FoldTest, SwappingStatesPreservesBoth) {
  const Numbers swapped = fold(3, {x, y}, [&](const Numbers& s, Expression) {
    return Numbers{s[1], s[0]};
  });
  EXPECT_DOUBLE_EQ(at(swapped[0], 1, 2), 2);
  EXPECT_EQ(code(swapped[0]),
            "float y;\n{\n"
            "  float t0 = x;\n"
            "  float t1 = y;\n"
            "  for (int t2 = 0; t2 < 3; t2++) {\n"
            "    float t3 = t1;\n"
            "    float t4 = t0;\n"
            "    t0 = t3;\n"
            "    t1 = t4;\n"
            "  }\n"
            "  y = t0;\n}\n");
}

// Computes bounds of a fold, and compares them with the values of the same loop in C++.
TEST_F(FoldTest, BoundsContainAllValues) {
  Module module;
  const Expression a = scalar(module.graph, "a");
  const Expression f = fold(5, {a}, [&](const Numbers& s, Expression i) {
    return Numbers{sin(s[0] * 2.0) + i * a * 0.1};
  })[0];
  module.outputs.push_back({"f", scalarShape, {f.id}});
  const std::uint32_t first = 0;
  const Program compiled = *program(module, {&first, 1}).program;
  const Range range{-1, 1};
  const Range found = bounds(compiled.words, compiled.instructions, {&range, 1}, {&first, 1})[0];
  double lowest = 10, highest = -10;
  for (double value = -1; value <= 1; value += 1e-3) {
    double s = value;
    for (int i = 0; i < 5; ++i) s = std::sin(s * 2) + i * value * 0.1;
    lowest = std::min(lowest, s);
    highest = std::max(highest, s);
  }
  EXPECT_LE(found.low, lowest);
  EXPECT_GE(found.high, highest);
  EXPECT_LT(found.high - found.low, 1.1 * (highest - lowest));
}

// Returns the sum of x and n halves of y, by a loop that ends by itself.
Expression addHalves(Expression x, Expression y, Expression n) {
  const Expression zero{x.graph, x.graph->constant(0)};
  return fold(uncountedSteps, {zero, x}, [&](const Numbers& s, Expression i) {
    const Expression isOver = logicalOr(gt(s[0], 0.5), gt(i + 0.5, n));
    return Numbers{ifElse(isOver, 1.0, s[0]), ifElse(isOver, s[1], s[1] + y * 0.5)};
  })[1];
}

TEST_F(FoldTest, AnUncountedLoopBreaksInTheShader) {
  const Expression zero{&graph, graph.constant(0)}, one{&graph, graph.constant(1)};
  // The simplifier rewrites the change of sign as a product, which says nothing about the end.
  const Expression signs = fold(uncountedSteps, {zero, one}, [&](const Numbers& s, Expression i) {
    const Expression isOver = logicalOr(gt(s[0], 0.5), gt(i, x));
    return Numbers{ifElse(isOver, 1.0, s[0]), ifElse(isOver, s[1], -s[1])};
  })[1];
  for (const Dialect* dialect : {&glsl300, &glsl100, &wgsl}) {
    const std::string text = code(signs, 8, *dialect);
    EXPECT_NE(text.find("< 4194304;"), std::string::npos) << text;
    EXPECT_NE(text.find("{ break; }"), std::string::npos) << text;
  }
}

TEST_F(FoldTest, AnUncountedLoopEndsOnTheCpu) {
  const Expression sum = addHalves(x, y, y);
  for (const double n : {0.0, 1.0, 7.0, 256.0})
    EXPECT_DOUBLE_EQ(at(sum, 3, n), 3 + n * n * 0.5) << n;
  EXPECT_DOUBLE_EQ(at(derivative(sum, y), 3, 8), 4);
}

TEST_F(FoldTest, AnUncountedLoopThatIsTooLongForTheCpuHasNoValue) {
  EXPECT_TRUE(std::isnan(at(addHalves(x, y, y), 3, 257)));
  // Nested loops multiply their steps.
  const Expression zero{&graph, graph.constant(0)};
  const Expression nested = fold(uncountedSteps, {zero, x}, [&](const Numbers& s, Expression i) {
    const Expression isOver = logicalOr(gt(s[0], 0.5), gt(i + 0.5, y));
    return Numbers{ifElse(isOver, 1.0, s[0]),
                   ifElse(isOver, s[1], addHalves(sin(s[1]), cos(x), y * 2.0))};
  })[1];
  EXPECT_TRUE(std::isfinite(at(nested, 0.5, 3)));
  EXPECT_TRUE(std::isnan(at(nested, 0.5, 250)));
}

TEST_F(FoldTest, BoundsOfAnUncountedLoopContainAllValues) {
  Module module;
  const Expression a = scalar(module.graph, "a"), b = scalar(module.graph, "b");
  module.outputs.push_back({"f", scalarShape, {addHalves(a, b, b).id}});
  const std::uint32_t first = 0;
  const Program compiled = *program(module, {&first, 1}).program;
  const auto boundsTo = [&](double n) {
    const Range ranges[] = {{1, 2}, {0, n}};
    return bounds(compiled.words, compiled.instructions, ranges, {&first, 1})[0];
  };
  const Range near = boundsTo(4), far = boundsTo(400);
  EXPECT_LE(near.low, 1);
  EXPECT_GE(near.high, 2 + 4 * 4 * 0.5);
  EXPECT_TRUE(std::isfinite(near.high));
  EXPECT_LE(far.low, 1);
  EXPECT_GE(far.high, 2 + 400 * 400 * 0.5);
}

TEST_F(FoldTest, SurvivesSerializationInAModule) {
  Module module;
  const Expression a = scalar(module.graph, "a");
  module.methods.push_back("param");
  const Expression f =
      fold(6, {a}, [&](const Numbers& s, Expression i) { return Numbers{sin(s[0]) + i * a}; })[0];
  module.outputs.push_back({"f", scalarShape, {f.id}});
  const Module loaded = load(save(module));
  EXPECT_EQ(emit(loaded.graph, glsl300, loaded.outputs).code,
            emit(module.graph, glsl300, module.outputs).code);
}

}  // namespace
}  // namespace warpjet
