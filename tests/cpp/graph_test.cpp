// The graph: equal nodes are interned, constants are folded, identities hold.
#include "graph/graph.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace warpjet {
namespace {

class GraphTest : public testing::Test {
 protected:
  Graph graph;
  Expression x = scalar(graph, "x");
  Expression y = scalar(graph, "y");

  void expectConstant(Expression e, double value) {
    ASSERT_TRUE(graph.isConstant(e.id));
    EXPECT_EQ(graph.value(e.id), value);
  }
};

TEST_F(GraphTest, InternsEqualOperations) {
  EXPECT_EQ(sin(x + y).id, sin(x + y).id);
  EXPECT_EQ((x + y).id, (y + x).id);
  EXPECT_EQ((x * 2.0).id, (2.0 * x).id);
  EXPECT_NE((x - y).id, (y - x).id);
}

TEST_F(GraphTest, ReturnsTheSameNodeForTheSameInput) {
  EXPECT_EQ(scalar(graph, "x").id, x.id);
  EXPECT_NE(x.id, y.id);
}

TEST_F(GraphTest, PreservesEveryBitOfConstants) {
  for (const double value : {0.1, 1e-30, 98765.4321, -0.00049, 1e21})
    EXPECT_EQ(graph.value(graph.constant(value)), value);
  EXPECT_NE(graph.constant(0.0), graph.constant(-0.0));
}

TEST_F(GraphTest, FoldsOperationsOnConstants) {
  const Expression two{&graph, graph.constant(2)};
  expectConstant(two * 3.0, 6);
  expectConstant(sqrt(two * 8.0), 4);
  expectConstant(ifElse(lt(two, 3.0), 5.0, 7.0), 5);
  expectConstant(ifElse(logicalAnd(lt(two, 3.0), lt(two, 1.0)), 5.0, 7.0), 7);
}

TEST_F(GraphTest, DoesNotFoldToInfinityOrNaN) {
  const Expression zero{&graph, graph.constant(0)};
  EXPECT_FALSE(graph.isLeaf((1.0 / zero).id));
  EXPECT_FALSE(graph.isLeaf(log(zero).id));
  EXPECT_FALSE(graph.isLeaf((Expression{&graph, graph.constant(1e30)} * 1e30).id));
}

TEST_F(GraphTest, RemovesNeutralElements) {
  EXPECT_EQ((x + 0.0).id, x.id);
  EXPECT_EQ((0.0 + x).id, x.id);
  EXPECT_EQ((x - 0.0).id, x.id);
  EXPECT_EQ((x * 1.0).id, x.id);
  EXPECT_EQ((x / 1.0).id, x.id);
  EXPECT_EQ((-(-x)).id, x.id);
  expectConstant(x * 0.0, 0);
  expectConstant(x - x, 0);
  expectConstant(0.0 / x, 0);
}

TEST_F(GraphTest, MovesSignsOutwards) {
  EXPECT_EQ((x + -y).id, (x - y).id);
  EXPECT_EQ((x - -y).id, (x + y).id);
  EXPECT_EQ((-x * -y).id, (x * y).id);
  EXPECT_EQ((-x * y).id, (-(x * y)).id);
  EXPECT_EQ((0.0 - x).id, (-x).id);
  EXPECT_EQ((x + -(x - y)).id, (x - (x - y)).id) << "the existing difference is used";
}

TEST_F(GraphTest, ExpandsIntegerPowersToProducts) {
  EXPECT_EQ(pow(x, 1.0).id, x.id);
  EXPECT_EQ(pow(x, 2.0).id, (x * x).id);
  EXPECT_EQ(pow(x, -1.0).id, (1.0 / x).id);
  expectConstant(pow(x, 0.0), 1);
  EXPECT_TRUE(graph.is(pow(x, 2.5).id, ops::find("pow")));
  EXPECT_TRUE(graph.is(pow(x, 17.0).id, ops::find("pow")));
  for (const double n : {3.0, 5.0, 7.0, 16.0, -3.0})
    EXPECT_DOUBLE_EQ(evaluateNode(graph, pow(x, n).id, {{x.id, -1.5}}), std::pow(-1.5, n)) << n;
}

TEST_F(GraphTest, ConvertsBetweenConditionsAndNumbers) {
  const Expression sum = lt(x, y) + 1.0;
  EXPECT_EQ(graph.type(sum.id), ops::Type::Float);
  EXPECT_EQ(evaluateNode(graph, sum.id, {{x.id, 1}, {y.id, 2}}), 2);
  const Expression chosen = ifElse(x, 5.0, 7.0);
  EXPECT_EQ(evaluateNode(graph, chosen.id, {{x.id, -3}}), 5);
  EXPECT_EQ(evaluateNode(graph, chosen.id, {{x.id, 0}}), 7);
}

TEST_F(GraphTest, MergesChoicesWithTheSameCondition) {
  const Expression c = lt(x, y);
  EXPECT_EQ((ifElse(c, x, 0.0) + ifElse(c, 0.0, y)).id, ifElse(c, x, y).id);
  EXPECT_EQ((ifElse(c, 1.0, 0.0) * y).id, ifElse(c, y, 0.0).id);
  EXPECT_EQ(ifElse(c, x, x).id, x.id);
}

TEST_F(GraphTest, DistinguishesInputsByShape) {
  EXPECT_EQ(graph.input("m", matrixOf(2, 3)), graph.input("m", matrixOf(2, 3)));
  EXPECT_NE(graph.input("m", matrixOf(2, 3)), graph.input("m", matrixOf(3, 2)));
  EXPECT_EQ(graph.input(graph.input("m", matrixOf(3, 2))).shape, matrixOf(3, 2));
}

TEST_F(GraphTest, CallsPreserveTheOrderOfArguments) {
  const std::uint32_t noise = graph.addFunction({"noise", 3}),
                      other = graph.addFunction({"other", 3});
  const std::vector<NodeId> arguments{y.id, x.id, y.id};
  const NodeId call = graph.call(noise, arguments);
  EXPECT_EQ(graph.arguments(call), arguments);
  EXPECT_EQ(graph.function(call).name, "noise");
  EXPECT_EQ(graph.type(call), ops::Type::Float);
  EXPECT_EQ(graph.call(noise, arguments), call);
  EXPECT_NE(graph.call(other, arguments), call);
  EXPECT_NE(graph.call(noise, std::vector{x.id, y.id, y.id}), call);
}

TEST_F(GraphTest, ACallStoresASingleArgumentWithoutAList) {
  const std::uint32_t bump = graph.addFunction({"bump", 1});
  const NodeId call = graph.call(bump, std::vector{x.id});
  EXPECT_EQ(graph.arguments(call), std::vector{x.id});
  EXPECT_EQ(graph.arguments(graph.call(bump, std::vector{call})), std::vector{call});
}

TEST_F(GraphTest, ConvertsConditionsPassedAsArgumentsToNumbers) {
  const std::uint32_t bump = graph.addFunction({"bump", 1});
  const NodeId argument = graph.arguments(graph.call(bump, std::vector{lt(x, y).id}))[0];
  EXPECT_EQ(graph.type(argument), ops::Type::Float);
}

TEST_F(GraphTest, NeverFoldsCalls) {
  const std::uint32_t bump = graph.addFunction({"bump", 1});
  EXPECT_TRUE(graph.isCall(graph.call(bump, std::vector{graph.constant(1)})));
}

TEST_F(GraphTest, StoresPartialsPerCall) {
  const std::uint32_t noise = graph.addFunction({"noise", 2});
  const NodeId call = graph.call(noise, std::vector{x.id, y.id}),
               swapped = graph.call(noise, std::vector{y.id, x.id});
  EXPECT_FALSE(graph.hasPartials(call));
  const std::vector<NodeId> partials{graph.constant(3), x.id};
  graph.setPartials(call, partials);
  EXPECT_TRUE(graph.hasPartials(call));
  EXPECT_EQ(graph.partials(call), partials);
  EXPECT_FALSE(graph.hasPartials(swapped));
}

TEST_F(GraphTest, ReportsWhichOperationsItContains) {
  EXPECT_FALSE(graph.has(rowNamed("tanh")));
  graph.apply(rowNamed("tanh"), {x.id});
  EXPECT_TRUE(graph.has(rowNamed("tanh")));
  EXPECT_FALSE(graph.has(rowNamed("sin")));
}

TEST_F(GraphTest, LeavesOperationsUnchangedIfSimplificationIsOff) {
  Graph plain(Graph::maxNodes, Graph::Simplification::Off);
  const Expression a = scalar(plain, "a"), zero{&plain, plain.constant(0)};
  EXPECT_TRUE(plain.is((a + 0.0).id, rowNamed("add")));
  EXPECT_TRUE(plain.is((zero * 2.0).id, rowNamed("mult")));
  EXPECT_TRUE(plain.is((-(-a)).id, rowNamed("neg")));
  EXPECT_NE((a + zero).id, (zero + a).id);
  EXPECT_EQ((a + zero).id, (a + zero).id) << "equal nodes are interned nevertheless";
}

// If the lower bound exceeds the upper one, the result is the upper one; WGSL rejects such
// constants.
TEST_F(GraphTest, ClampWithCrossedConstantBoundsReturnsTheUpperOne) {
  const auto clamped = [&](double low, double high) {
    return graph.apply(rowNamed("clamp"), {x.id, graph.constant(low), graph.constant(high)});
  };
  EXPECT_EQ(clamped(2, 1), graph.constant(1));
  EXPECT_TRUE(graph.is(clamped(1, 1), rowNamed("clamp")));
}

// 1e-60 is zero in float32 and 1e60 is infinite, although x * 1e-30 * 1e-30 may be greater than
// zero, and x * 1e30 * 1e30 finite.
TEST_F(GraphTest, MultipliesConstantFactorsOnlyIfFloat32HoldsTheProduct) {
  EXPECT_EQ((x * 2.0 * 3.0).id, (x * 6.0).id);
  EXPECT_TRUE(graph.is(graph.operand((x * 1e-30 * 1e-30).id, 0), rowNamed("mult")));
  EXPECT_TRUE(graph.is(graph.operand((x * 1e30 * 1e30).id, 0), rowNamed("mult")));
}

TEST_F(GraphTest, RepeatedSquaringNeedsFewNodes) {
  Expression v = x;
  for (int i = 0; i < 40; ++i) v = v * v + v;
  EXPECT_LT(graph.size(), 100u);
}

TEST_F(GraphTest, AFullGraphStopsGrowingWithoutCrashing) {
  Graph small(1000);
  const Expression input = scalar(small, "x");
  Expression v = input;
  while (!small.isFull()) v = sin(v);
  for (int i = 0; i < 100; ++i) v = (v - 1.0) * -2.0 + input;
  EXPECT_EQ(small.size(), 1000u);
}

}  // namespace
}  // namespace warpjet
