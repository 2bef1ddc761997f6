// Derivatives at huge, tiny and zero arguments, where intermediate results overflow or underflow in
// float32: compared with closed forms in long double.
#include <gtest/gtest.h>

#include <functional>

#include "algebra/vectors.hpp"
#include "diff/differentiator.hpp"
#include "support.hpp"
#include "warp/warp.hpp"

namespace warpjet {
namespace {

constexpr double minNormal = std::numeric_limits<float>::min();

// Returns the float32 value that a shader uses, where denormals may be flushed to zero.
double asFloat(double x, bool flushes) {
  const double rounded = static_cast<float>(x);
  return flushes && std::abs(rounded) < minNormal ? std::copysign(0.0, rounded) : rounded;
}

// Returns the value of a node, with the result of each operation rounded to float32.
double evaluateFloat(const Graph& graph, NodeId root, const Inputs& inputs, bool flushes) {
  std::map<NodeId, double> values;
  for (const NodeId id : reachable(graph, {&root, 1})) {
    double value;
    if (graph.isConstant(id)) {
      value = graph.value(id);
    } else if (graph.isInput(id)) {
      value = inputs.at(id);
    } else {
      Operands<double> x{};
      for (int i = 0; i < graph.arity(id); ++i) x[i] = values[graph.operand(id, i)];
      value = ops::valueOf(graph.node(id).op, x);
    }
    values[id] = asFloat(value, flushes);
  }
  return values[root];
}

using Real = long double;

struct Case {
  const char* name;
  std::function<Expression(Expression)> formula;
  std::function<Real(Real)> derivative;
  // Compositions are checked up to |x| = 1.1e18. Beyond that, intermediate results such as x^2 come
  // close to the max of float32 or exceed it, so nothing is guaranteed.
  bool isComposition = false;
};

Expression applyRow(const char* name, Expression x) {
  return {x.graph, x.graph->apply(rowNamed(name), {x.id})};
}
Expression constant(Expression x, double value) { return {x.graph, x.graph->constant(value)}; }

Real sech(Real x) { return 2 / (std::exp(x) + std::exp(-x)); }

// Operations of the table.
const std::vector<Case> rows{
    {"inversesqrt", [](auto x) { return inversesqrt(x); },
     [](Real x) { return -0.5L / (x * std::sqrt(x)); }},
    {"sqrt", [](auto x) { return sqrt(x); },
     [](Real x) { return x == 0 ? 0 : 0.5L / std::sqrt(x); }},
    {"exp", [](auto x) { return exp(x); }, [](Real x) { return std::exp(x); }},
    {"exp2", [](auto x) { return applyRow("exp2", x); },
     [](Real x) { return std::exp2(x) * std::log(2.0L); }},
    {"log", [](auto x) { return log(x); }, [](Real x) { return 1 / x; }},
    {"log2", [](auto x) { return applyRow("log2", x); },
     [](Real x) { return 1 / (x * std::log(2.0L)); }},
    {"asin", [](auto x) { return asin(x); },
     [](Real x) { return std::abs(x) == 1 ? 0 : 1 / std::sqrt((1 - x) * (1 + x)); }},
    {"acos", [](auto x) { return acos(x); },
     [](Real x) { return std::abs(x) == 1 ? 0 : -1 / std::sqrt((1 - x) * (1 + x)); }},
    {"atan", [](auto x) { return atan(x); }, [](Real x) { return 1 / (1 + x * x); }},
    {"sinh", [](auto x) { return sinh(x); }, [](Real x) { return std::cosh(x); }},
    {"cosh", [](auto x) { return cosh(x); }, [](Real x) { return std::sinh(x); }},
    {"tanh", [](auto x) { return applyRow("tanh", x); }, [](Real x) { return sech(x) * sech(x); }},
    {"acosh", [](auto x) { return applyRow("acosh", x); },
     [](Real x) { return x == 1 ? 0 : 1 / std::sqrt((x - 1) * (x + 1)); }},
    {"atanh", [](auto x) { return applyRow("atanh", x); },
     [](Real x) { return 1 / ((1 - x) * (1 + x)); }},
    {"x / 3", [](auto x) { return x / 3.0; }, [](Real) { return 1 / 3.0L; }},
    {"1 / x", [](auto x) { return 1.0 / x; }, [](Real x) { return -1 / (x * x); }},
    {"pow(x, 0.3)", [](auto x) { return pow(x, 0.3); },
     [](Real x) { return x == 0 ? 0 : 0.3 * std::pow(x, 0.3L - 1); }},
    {"pow(x, -1.5)", [](auto x) { return pow(x, -1.5); },
     [](Real x) { return -1.5L * std::pow(x, -2.5L); }},
    {"pow(1.5, x)", [](auto x) { return pow(constant(x, 1.5), x); },
     [](Real x) { return std::pow(1.5L, x) * std::log(1.5L); }},
    {"atan2(x, 2)", [](auto x) { return atan2(x, 2.0); }, [](Real x) { return 2 / (x * x + 4); }},
    {"atan2(-1, x)", [](auto x) { return atan2(-1.0, x); }, [](Real x) { return 1 / (x * x + 1); }},
    {"atan2(x, 1e-20)", [](auto x) { return atan2(x, 1e-20); },
     [](Real x) { return 1e-20L / (x * x + 1e-40L); }},
};

// Cases in which an intermediate derivative is infinite and the value is finite.
const std::vector<Case> compositions{
    {"1 / (exp(-x) + 1)", [](auto x) { return 1.0 / (exp(-x) + 1.0); },
     [](Real x) {
       return x > 0 ? std::exp(-x) / ((std::exp(-x) + 1) * (std::exp(-x) + 1))
                    : std::exp(x) / ((1 + std::exp(x)) * (1 + std::exp(x)));
     }},
    {"1 / cosh(x)", [](auto x) { return 1.0 / cosh(x); },
     [](Real x) { return -std::tanh(x) * sech(x); }},
    {"1 / (exp(x * 50) + 1)", [](auto x) { return 1.0 / (exp(x * 50.0) + 1.0); },
     [](Real x) {
       const Real e = std::exp(-50 * std::abs(x));
       return -50 * e / ((e + 1) * (e + 1));
     }},
    {"atan(exp(x))", [](auto x) { return atan(exp(x)); }, [](Real x) { return sech(x) / 2; }},
    {"exp(-1 / x^2)", [](auto x) { return exp(-1.0 / (x * x)); },
     [](Real x) { return x == 0 ? 0 : std::exp(-1 / (x * x)) * 2 / (x * x * x); }},
    {"exp(-1 / |x|)", [](auto x) { return exp(-1.0 / abs(x)); },
     [](Real x) { return x == 0 ? 0 : std::exp(-1 / std::abs(x)) / (x * std::abs(x)); }},
    {"exp2(-1 / x^2)", [](auto x) { return applyRow("exp2", -1.0 / (x * x)); },
     [](Real x) {
       return x == 0 ? 0 : std::exp2(-1 / (x * x)) * 2 * std::log(2.0L) / (x * x * x);
     }},
    {"atan(3 / x)", [](auto x) { return atan(3.0 / x); }, [](Real x) { return -3 / (x * x + 9); }},
    {"atan(x / 1e-30)", [](auto x) { return atan(x / 1e-30); },
     [](Real x) { return 1e-30L / (x * x + 1e-60L); }},
    {"tanh(1 / x)", [](auto x) { return applyRow("tanh", 1.0 / x); },
     [](Real x) { return x == 0 ? 0 : -sech(1 / x) * sech(1 / x) / (x * x); }},
    {"tanh(exp(x))", [](auto x) { return applyRow("tanh", exp(x)); },
     [](Real x) { return x > 20 ? 0 : sech(std::exp(x)) * sech(std::exp(x)) * std::exp(x); }},
    {"1 / x^2", [](auto x) { return 1.0 / (x * x); }, [](Real x) { return -2 / (x * x * x); }},
    {"1 / (1 + 1 / x^2)", [](auto x) { return 1.0 / (1.0 / (x * x) + 1.0); },
     [](Real x) { return 2 * x / ((x * x + 1) * (x * x + 1)); }},
    {"x / sqrt(x^2 + 1)", [](auto x) { return x / sqrt(x * x + 1.0); },
     [](Real x) { return 1 / ((x * x + 1) * std::sqrt(x * x + 1)); }},
    {"x / (1 + |x|)", [](auto x) { return x / (abs(x) + 1.0); },
     [](Real x) { return 1 / ((1 + std::abs(x)) * (1 + std::abs(x))); }},
    {"inversesqrt(exp(x) + 1)", [](auto x) { return inversesqrt(exp(x) + 1.0); },
     [](Real x) { return x > 100 ? 0 : -0.5L * std::exp(x) / std::pow(1 + std::exp(x), 1.5L); }},
    {"pow(exp(x) + 1, -0.5)", [](auto x) { return pow(exp(x) + 1.0, -0.5); },
     [](Real x) { return x > 100 ? 0 : -0.5L * std::exp(x) / std::pow(1 + std::exp(x), 1.5L); }},
    {"exp(-x^2)", [](auto x) { return exp(-(x * x)); },
     [](Real x) { return -2 * x * std::exp(-x * x); }},
    {"exp(-exp(x))", [](auto x) { return exp(-exp(x)); },
     [](Real x) { return x > 20 ? 0 : -std::exp(x - std::exp(x)); }},
    {"sin(exp(-1 / x^2))", [](auto x) { return sin(exp(-1.0 / (x * x))); },
     [](Real x) {
       const Real e = std::exp(-1 / (x * x));
       return x == 0 ? 0 : std::cos(e) * e * 2 / (x * x * x);
     }},
    {"atan2(x * 1e20, 1e20)", [](auto x) { return atan2(x * 1e20, 1e20); },
     [](Real x) { return 1 / (x * x + 1); }},
    {"atan2(exp(x), 1)", [](auto x) { return atan2(exp(x), 1.0); },
     [](Real x) { return sech(x) / 2; }},
    {"max(1 / x^2, 3)", [](auto x) { return max(1.0 / (x * x), 3.0); },
     [](Real x) { return 1 / (x * x) < 3 ? 0 : -2 / (x * x * x); }},
};

std::vector<double> arguments() {
  std::vector<double> all{0};
  for (const double size :
       {2e-38, 1e-30, 1e-25, 1e-20, 1e-19, 1e-16, 1e-13, 1e-10, 1e-7, 1e-4, 0.01, 0.1,  0.3,  0.5,
        0.99,  1.0,   1.7,   3.0,   7.0,   9.0,   13.0,  20.0,  44.0, 50.0, 60.0, 80.0, 87.0, 88.0,
        89.0,  100.0, 150.0, 1e3,   1e5,   1e10,  1e15,  1e18,  1e19, 1e20, 1e25, 1e30, 1e37}) {
    all.push_back(static_cast<float>(size));
    all.push_back(-static_cast<float>(size));
  }
  return all;
}

class Float32 : public testing::TestWithParam<Case> {};

TEST_P(Float32, TheDerivativeIsFiniteWhereverTheValueIs) {
  const Case& test = GetParam();
  Graph graph;
  Differentiator differentiator(graph);
  const Expression x = scalar(graph, "x"), f = test.formula(x);
  const NodeId slope = differentiator.derivative(f.id, x.id);
  int checked = 0;
  for (const double argument : arguments()) {
    if (test.isComposition && std::abs(argument) > 1.1e18) continue;
    for (const bool flushes : {false, true}) {
      const Inputs inputs{{x.id, argument}};
      if (!std::isfinite(evaluateFloat(graph, f.id, inputs, flushes))) continue;
      const auto exact = static_cast<double>(test.derivative(argument));
      // float32 can't represent the derivative.
      if (!(std::abs(exact) < 1e37)) continue;
      const double found = evaluateFloat(graph, slope, inputs, flushes);
      EXPECT_NEAR(found, exact, 2e-5 * std::abs(exact) + 1e-8) << test.name << " at " << argument;
      ++checked;
    }
  }
  EXPECT_GE(checked, 20) << test.name;
}

INSTANTIATE_TEST_SUITE_P(Rows, Float32, testing::ValuesIn(rows));
INSTANTIATE_TEST_SUITE_P(Compositions, Float32, testing::ValuesIn([] {
                           std::vector<Case> all = compositions;
                           for (Case& test : all) test.isComposition = true;
                           return all;
                         }()));

// --- vectors

class Float32Warp : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Value p = vector3(graph, "position"), n = vector3(graph, "normal");
  Expression zero{&graph, graph.constant(0)};

  using Point = std::array<double, 3>;

  Value vec3(Expression x, Expression y, Expression z) const {
    const std::array all{x, y, z};
    return fill(*x.graph, vectorOf(3), [&](int i) { return all[static_cast<std::size_t>(i)]; });
  }
  Inputs inputsAt(const Point& position, const Point& normal) const {
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
      inputs[p[i].id] = static_cast<float>(position[i]);
      inputs[n[i].id] = static_cast<float>(normal[i]);
    }
    return inputs;
  }
  void expectNormal(const Value& offset, const Point& position, const Point& normal,
                    const Point& expected) {
    const Value warped = warpNormal(deformation(differentiator, offset, p), n);
    for (const bool flushes : {false, true}) {
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(evaluateFloat(graph, warped[i].id, inputsAt(position, normal), flushes),
                    expected[i], 1e-6)
            << "component " << i;
    }
  }
};

TEST_F(Float32Warp, TheNormalIsCorrectForHugeOffsets) {
  expectNormal(p * 1e37, {1, 2, 3}, {0, 0.6, 0.8}, {0, 0.6, 0.8});
  for (const double size : {1e8, 1e10, 1e15, 1e20, 1e30}) {
    expectNormal(p * size, {1, 2, 3}, {0, 0.6, 0.8}, {0, 0.6, 0.8});
    // With (x + s y, y, z), the normal (0, 1, 0) is unchanged, and (1, 0, 0) leans towards -y.
    expectNormal(vec3(p[1] * size, zero, zero), {1, 2, 3}, {0, 1, 0}, {0, 1, 0});
    expectNormal(vec3(p[1] * size, zero, zero), {1, 2, 3}, {1, 0, 0}, {0, -1, 0});
    expectNormal(vec3(p[1] * p[1] * size, zero, zero), {1, 2, 3}, {1, 0, 0}, {0, -1, 0});
  }
}

TEST_F(Float32Warp, AHugeStretchAlongOneAxisPreservesTheOtherAxes) {
  expectNormal(vec3(p[0] * 1e12, zero, zero), {1, 2, 3}, {1, 0, 0}, {1, 0, 0});
  expectNormal(vec3(p[0] * 1e12, zero, zero), {1, 2, 3}, {0.6, 0.8, 0}, {0, 1, 0});
}

// The nearer to the axis, the faster the unit vector rotates. These points are on a coordinate
// axis, so the expected values are exact.
TEST_F(Float32Warp, AUnitVectorIsAccurateNearItsAxis) {
  for (const double x : {1e-4, 1e-7, 1e-10, 1e-13, 1e-16, 1e-18}) {
    const Expression squared = p[0] * p[0] + p[2] * p[2];
    const Expression shorten = ifElse(gt(squared, 0.0), inversesqrt(squared), 0.0);
    const Inputs inputs = inputsAt({x, 0, 0}, {0, 1, 0});
    const auto slope = [&](Expression f, int axis) {
      return evaluateFloat(graph, differentiator.derivative(f.id, p[axis].id), inputs, true);
    };
    // With r = sqrt(x^2 + z^2), at z = 0: ∂(x / r)/∂x = 0 and ∂(z / r)/∂z = 1 / |x|.
    EXPECT_NEAR(slope(p[0] * shorten, 0) * x, 0, 1e-6) << x;
    EXPECT_NEAR(slope(p[2] * shorten, 2) * x, 1, 1e-6) << x;
    EXPECT_EQ(slope(p[0] * shorten, 2), 0) << x;
    EXPECT_NEAR(slope(p[0] / sqrt(squared), 0) * x, 0, 1e-6) << x;
    EXPECT_NEAR(slope(p[2] / sqrt(squared), 2) * x, 1, 1e-6) << x;
    expectNormal(vec3(p[0] * shorten, zero, p[2] * shorten), {x, 0, 0}, {0, 1, 0}, {0, 1, 0});
  }
}

// If the slope is unknown, the normal is zero.
TEST_F(Float32Warp, AnInfiniteSlopeGivesAZeroNormal) {
  const Expression steep = pow(p[0], -3.0);
  expectNormal(vec3(zero, steep, zero), {1e-12, 0, 0}, {0, 1, 0}, {0, 0, 0});
}

}  // namespace
}  // namespace warpjet
