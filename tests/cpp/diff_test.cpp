// Derivatives of graphs, compared with formulas derived by hand.
#include <gtest/gtest.h>

#include "diff/differentiator.hpp"
#include "sanitized.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

class DiffTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Expression x = scalar(graph, "x");
  Expression y = scalar(graph, "y");

  Expression derivative(Expression f, Expression variable) {
    return {&graph, differentiator.derivative(f.id, variable.id)};
  }
  double at(Expression f, double xValue, double yValue = 0) {
    return evaluateNode(graph, f.id, {{x.id, xValue}, {y.id, yValue}});
  }
};

TEST_F(DiffTest, DifferentiatesInputsAndConstants) {
  EXPECT_EQ(at(derivative(x, x), 3), 1);
  EXPECT_EQ(at(derivative(y, x), 3, 5), 0);
  EXPECT_EQ(at(derivative({&graph, graph.constant(7)}, x), 3), 0);
}

// A sum of many sines is added to a sum of parameters. The sines read no parameter, but each
// further sum depends on all parameters.
TEST_F(DiffTest, HundredsOfParametersOfALargeGraphNeedLittleMemory) {
  constexpr int count = isSanitized ? 100 : 300;
  std::vector<Expression> parameters;
  Expression sum = x;
  for (int i = 0; i < count; ++i) {
    parameters.push_back(scalar(graph, "p" + std::to_string(i)));
    sum = sum + parameters.back() * static_cast<double>(i);
  }
  constexpr int operations = 30000;
  for (int i = 0; i < operations / 2; ++i) sum = sum + sin(x + static_cast<double>(i));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Expression slope = derivative(sum, parameters[i]);
    EXPECT_TRUE(graph.isConstant(slope.id, static_cast<double>(i))) << i;
  }
  EXPECT_LT(differentiator.bytes(), std::size_t{130} << 20);
}

TEST_F(DiffTest, ThousandsOfParametersNeedMemoryOnlyForTheirDependents) {
  constexpr int count = 3000;
  for (int i = 0; i < count; ++i) {
    const Expression p = scalar(graph, "p" + std::to_string(i));
    const Expression slope = derivative(p * sin(p), p);
    EXPECT_EQ(slope.id, (sin(p) + p * cos(p)).id) << i;
  }
  EXPECT_LT(differentiator.bytes(), std::size_t{count} * 4 * 512 * 12);
}

TEST_F(DiffTest, AppliesTheProductQuotientAndChainRules) {
  const Expression f = sin(x * y) / (x + 2.0);
  const double a = 0.7, b = -1.3;
  EXPECT_DOUBLE_EQ(at(derivative(f, x), a, b),
                   (b * std::cos(a * b) * (a + 2) - std::sin(a * b)) / ((a + 2) * (a + 2)));
  EXPECT_DOUBLE_EQ(at(derivative(f, y), a, b), a * std::cos(a * b) / (a + 2));
}

TEST_F(DiffTest, DifferentiatesToAnyOrder) {
  Expression f = sin(x * 2.0);
  for (int i = 0; i < 4; ++i) f = derivative(f, x);
  EXPECT_NEAR(at(f, 0.3), 16 * std::sin(0.6), 1e-12);
}

TEST_F(DiffTest, DifferentiatesPowersOfANegativeBase) {
  EXPECT_DOUBLE_EQ(at(derivative(pow(x, 3.0), x), -2), 12);
  EXPECT_DOUBLE_EQ(at(derivative(pow(x, -2.0), x), -2), 0.25);
}

TEST_F(DiffTest, DifferentiatesVaryingBoundsOfClamp) {
  const Expression clamped = min(max(x, y), y * y);
  EXPECT_EQ(at(derivative(clamped, y), 10, 3), 6);
  EXPECT_EQ(at(derivative(clamped, x), 10, 3), 0);
  EXPECT_EQ(at(derivative(clamped, x), 4, 3), 1);
}

TEST_F(DiffTest, TheSlopeOfARootIsZeroInsteadOfNaNAtItsKink) {
  EXPECT_EQ(at(derivative(sqrt(x * x + y * y), x), 0, 0), 0);
  EXPECT_DOUBLE_EQ(at(derivative(sqrt(x * x + y * y), x), 3, 4), 0.6);
}

TEST_F(DiffTest, TheSlopeIsZeroInsteadOfInfiniteAtTheEdgeOfADomain) {
  EXPECT_EQ(at(derivative(atan2(y, x), x), 0, 0), 0);
  EXPECT_EQ(at(derivative(atan2(y, x), y), 0, 0), 0);
  EXPECT_EQ(at(derivative(asin(x), x), 1), 0);
  EXPECT_EQ(at(derivative(acos(x), x), -1), 0);
  EXPECT_EQ(at(derivative(pow(x, 0.5), x), 0), 0);
  EXPECT_DOUBLE_EQ(at(derivative(asin(x), x), 0.6), 1.25);
}

// 0 * infinity is NaN, so the choice must be applied after the product.
TEST_F(DiffTest, AnInfinityInTheBranchNotTakenHasNoEffect) {
  const Expression guarded = ifElse(gt(x, 0.0), log(x), 0.0) + ifElse(gt(x, 0.0), y / x, 0.0);
  EXPECT_EQ(at(derivative(guarded, x), 0, 1), 0);
  EXPECT_EQ(at(derivative(guarded, y), 0, 1), 0);
  EXPECT_EQ(at(derivative(min(1.0 / x, y), x), 0, 5), 0);
  EXPECT_EQ(at(derivative(min(-(1.0 / x), y) * 3.0, x), 2, 5), 0.75);
}

TEST_F(DiffTest, TheBranchNotTakenHasNoEffect) {
  const Expression f = ifElse(gt(x, 0.0), log(x), x * 5.0);
  EXPECT_EQ(at(derivative(f, x), -1), 5);
  EXPECT_EQ(at(derivative(f, x), 2), 0.5);
}

// f(u, v) with df/du = v and df/dv = 3: the chain rule adds u' v + 3 v'.
TEST_F(DiffTest, CallsFollowTheChainRuleWithTheirPartials) {
  const std::uint32_t f = graph.addFunction({"f", 2});
  const Expression u = sin(x), v = x * y;
  const NodeId call = graph.call(f, std::vector{u.id, v.id});
  graph.setPartials(call, std::vector{v.id, graph.constant(3)});
  const Expression f1{&graph, call};
  EXPECT_DOUBLE_EQ(at(derivative(f1, x), 0.5, 2), std::cos(0.5) * 1 + 3 * 2);
  EXPECT_DOUBLE_EQ(at(derivative(f1, y), 0.5, 2), 3 * 0.5);
  EXPECT_DOUBLE_EQ(at(derivative(f1 * 5.0, y), 0.5, 2), 15 * 0.5);
}

TEST_F(DiffTest, ACallIndependentOfTheInputHasNoDerivative) {
  const std::uint32_t f = graph.addFunction({"f", 1});
  const NodeId call = graph.call(f, std::vector{y.id});
  graph.setPartials(call, std::vector{y.id});
  EXPECT_TRUE(graph.isConstant(derivative({&graph, call}, x).id, 0));
}

// A partial that is infinite for a constant argument must not make the sum NaN.
TEST_F(DiffTest, IgnoresPartialsWithRespectToConstantArguments) {
  const std::uint32_t f = graph.addFunction({"f", 2});
  const NodeId call = graph.call(f, std::vector{x.id, y.id});
  graph.setPartials(call, std::vector{graph.constant(2), log(x).id});
  EXPECT_EQ(at(derivative({&graph, call}, x), 0, 0), 2);
}

TEST_F(DiffTest, ValueAndDerivativeShareNodes) {
  const Expression u = x * 3.0 + y;
  sin(u);
  const std::size_t before = graph.size();
  derivative(sin(u), x);
  EXPECT_LE(graph.size() - before, 4u) << "cos(u), its factor and constants; u already exists";
}

// With u = |p|^2, the gradient of exp(sin(u)) u is a common factor times (2x, 2y, 2z).
TEST_F(DiffTest, ColumnsShareFactorsAboveTheirCommonNode) {
  const Value p = vector3(graph, "p");
  const Expression u = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  const Expression f = exp(sin(u)) * u;
  const NodeId slopes[] = {derivative(f, p[0]).id, derivative(f, p[1]).id, derivative(f, p[2]).id};
  for (const NodeId id : slopes) {
    EXPECT_TRUE(graph.is(id, rowNamed("mult")));
    EXPECT_EQ(graph.operand(id, 0), graph.operand(slopes[0], 0));
  }
  const double a = 0.3, b = -0.7, c = 0.4, v = a * a + b * b + c * c;
  EXPECT_DOUBLE_EQ(evaluateNode(graph, slopes[1], {{p[0].id, a}, {p[1].id, b}, {p[2].id, c}}),
                   (std::exp(std::sin(v)) * std::cos(v) * v + std::exp(std::sin(v))) * 2 * b);
}

// At y = 0, the derivative of x / y with respect to y is infinite, but the branch with 10 is taken.
TEST_F(DiffTest, AnInfinityInTheBranchNotTakenHasNoEffectInAChain) {
  const Value p = vector3(graph, "p");
  const Expression quotient = p[0] / p[1], ten{&graph, graph.constant(10)};
  const Expression clamped{
      &graph, graph.apply(rowNamed("clamp"), {quotient.id, graph.constant(0), ten.id})};
  for (const Expression chosen :
       {min(quotient, ten), clamped, ifElse(lt(quotient, ten), quotient, ten),
        -max(-quotient, -ten)}) {
    const NodeId slope = derivative(sin(chosen), p[1]).id;
    EXPECT_EQ(evaluateNode(graph, slope, {{p[0].id, 1}, {p[1].id, 0}}), 0);
    EXPECT_DOUBLE_EQ(evaluateNode(graph, slope, {{p[0].id, 1}, {p[1].id, 2}}),
                     std::cos(0.5) * -0.25);
  }
}

// x contributes through u and directly.
TEST_F(DiffTest, AddsTheContributionsOfAllPathsFromAnInput) {
  const Value p = vector3(graph, "p");
  const Expression u = p[0] * p[1];
  const Expression f = sin(u) * p[0] + u;
  const double a = 0.9, b = -0.6;
  const Inputs inputs{{p[0].id, a}, {p[1].id, b}};
  EXPECT_DOUBLE_EQ(evaluateNode(graph, derivative(f, p[0]).id, inputs),
                   std::cos(a * b) * b * a + std::sin(a * b) + b);
  EXPECT_DOUBLE_EQ(evaluateNode(graph, derivative(f, p[1]).id, inputs),
                   std::cos(a * b) * a * a + a);
}

TEST_F(DiffTest, HandlesALongChainWithoutRecursion) {
  Expression f = x;
  for (int i = 0; i < 100'000; ++i) f = sin(f);
  derivative(f, x);
  EXPECT_LT(graph.size(), 450'000u);
}

}  // namespace
}  // namespace warpjet
