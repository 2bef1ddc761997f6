// The derivatives exactly at each kink that the comment at the top of ops/table.hpp lists.
#include <gtest/gtest.h>

#include "algebra/vectors.hpp"
#include "diff/differentiator.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The operands are inputs, so that no operation is folded before it is differentiated.
class KinksTest : public testing::Test {
 protected:
  Graph graph;
  Differentiator differentiator{graph};
  Value v = variable(graph, "v", vectorOf(3));

  // Returns the derivative of f with respect to v[component].
  double slope(Expression f, int component, const std::vector<double>& point) {
    Inputs inputs;
    for (std::size_t i = 0; i < point.size(); ++i) inputs[v[static_cast<int>(i)].id] = point[i];
    return evaluateNode(graph, differentiator.derivative(f.id, v[component].id), inputs);
  }
  // Returns the derivatives of a row with respect to each of its operands.
  std::vector<double> slopes(std::string_view row, const std::vector<double>& point) {
    const Op op = rowNamed(row);
    const Expression f{&graph, graph.apply(op, {v[0].id, v[1].id, v[2].id})};
    std::vector<double> all;
    for (int i = 0; i < ops::declaration(op).arity; ++i) all.push_back(slope(f, i, point));
    return all;
  }

  using Slopes = std::vector<double>;
};

TEST_F(KinksTest, TheSlopeOfAbsIsTheSign) {
  EXPECT_EQ(slopes("abs", {0}), Slopes{0});
  EXPECT_EQ(slopes("abs", {-2}), Slopes{-1});
}

TEST_F(KinksTest, StepsHaveTheSlopeZeroAtTheirJumpsToo) {
  for (const char* row : {"floor", "ceil", "trunc", "sign"}) {
    for (const double x : {-1.0, 0.0, 2.0}) EXPECT_EQ(slopes(row, {x}), Slopes{0}) << row << x;
  }
  for (const double x : {-0.5, 0.5, 1.5}) EXPECT_EQ(slopes("round", {x}), Slopes{0}) << x;
  EXPECT_EQ(slopes("step", {2, 2}), (Slopes{0, 0}));
  for (const char* row : {"lt", "le", "gt", "ge", "eq", "ne"})
    EXPECT_EQ(slopes(row, {1, 1}), (Slopes{0, 0})) << row;
}

TEST_F(KinksTest, FractAndModHaveTheSlopeOfTheirPieces) {
  EXPECT_EQ(slopes("fract", {3}), Slopes{1});
  EXPECT_EQ(slopes("mod", {6, 2}), (Slopes{1, -3}));
  EXPECT_EQ(slopes("mod", {-1, 2}), (Slopes{1, 1}));
}

TEST_F(KinksTest, MinAndMaxHaveTheSlopeOfTheFirstOfEqualOperands) {
  EXPECT_EQ(slopes("min", {2, 2}), (Slopes{1, 0}));
  EXPECT_EQ(slopes("max", {2, 2}), (Slopes{1, 0}));
}

// clamp is min(max(x, low), high): of equal operands, the first of x, low and high counts.
TEST_F(KinksTest, ClampHasTheSlopeOfTheOperandThatItReturns) {
  EXPECT_EQ(slopes("clamp", {0, 0, 1}), (Slopes{1, 0, 0})) << "x is low";
  EXPECT_EQ(slopes("clamp", {1, 0, 1}), (Slopes{1, 0, 0})) << "x is high";
  EXPECT_EQ(slopes("clamp", {1, 1, 1}), (Slopes{1, 0, 0})) << "all are equal";
  EXPECT_EQ(slopes("clamp", {0, 1, 1}), (Slopes{0, 1, 0})) << "low is high, x is less";
  EXPECT_EQ(slopes("clamp", {2, 1, 1}), (Slopes{0, 0, 1})) << "low is high, x is greater";
}

TEST_F(KinksTest, ClampWithCrossedBoundsFollowsTheUpperOne) {
  for (const double x : {0.0, 1.0, 1.5, 2.0, 3.0})
    EXPECT_EQ(slopes("clamp", {x, 2, 1}), (Slopes{0, 0, 1})) << x;
}

TEST_F(KinksTest, IfElseHasTheSlopeOfTheTakenBranch) {
  EXPECT_EQ(slopes("ifElse", {1, 2, 3}), (Slopes{0, 1, 0}));
  EXPECT_EQ(slopes("ifElse", {0, 2, 3}), (Slopes{0, 0, 1}));
}

TEST_F(KinksTest, TheSlopeIsZeroAtTheEdgeOfADomain) {
  EXPECT_EQ(slopes("sqrt", {0}), Slopes{0});
  EXPECT_EQ(slopes("sqrt", {-0.0}), Slopes{0});
  EXPECT_EQ(slopes("pow", {0, 0.5}), (Slopes{0, 0}));
  EXPECT_EQ(slopes("pow", {0, 1}), (Slopes{0, 0}));
  EXPECT_EQ(slopes("pow", {0, 0}), (Slopes{0, 0}));
  for (const double x : {-1.0, 1.0}) {
    EXPECT_EQ(slopes("asin", {x}), Slopes{0}) << x;
    EXPECT_EQ(slopes("acos", {x}), Slopes{0}) << x;
  }
  EXPECT_EQ(slopes("acosh", {1}), Slopes{0});
  EXPECT_EQ(slopes("atan2", {0, 0}), (Slopes{0, 0}));
}

TEST_F(KinksTest, TheSlopeIsZeroBeyondTheEdgeOfADomain) {
  EXPECT_EQ(slopes("sqrt", {-1}), Slopes{0});
  EXPECT_EQ(slopes("pow", {-2, 0.5}), (Slopes{0, 0}));
  EXPECT_EQ(slopes("pow", {-2, 2}), (Slopes{0, 0})) << "the exponent is an input, not whole";
  EXPECT_EQ(slopes("asin", {1.5}), Slopes{0});
  EXPECT_EQ(slopes("acos", {-1.5}), Slopes{0});
  EXPECT_EQ(slopes("acosh", {0.5}), Slopes{0});
}

TEST_F(KinksTest, IntegerPowersHaveTheirSlopeEverywhere) {
  EXPECT_EQ(slope(pow(v[0], 2.0), 0, {-3}), -6);
  EXPECT_EQ(slope(pow(v[0], 1.0), 0, {0}), 1);
  EXPECT_EQ(slope(pow(v[0], 3.0), 0, {0}), 0);
}

TEST_F(KinksTest, LengthDistAndNormalizeHaveFiniteSlopesAtZero) {
  const Value w = variable(graph, "w", vectorOf(3));
  for (int component = 0; component < 3; ++component) {
    EXPECT_EQ(slope(length(v), component, {0, 0, 0}), 0);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(slope(normalize(v)[i], component, {0, 0, 0}), 0);
    Inputs same;
    for (int i = 0; i < 3; ++i) same[v[i].id] = same[w[i].id] = i + 0.5;
    const NodeId slopeOfDist = differentiator.derivative(length(v - w).id, w[component].id);
    EXPECT_EQ(evaluateNode(graph, slopeOfDist, same), 0);
  }
}

TEST_F(KinksTest, TheSlopeIsInfiniteWhereTheValueIs) {
  EXPECT_EQ(slopes("log", {0}), Slopes{infinity});
  EXPECT_EQ(slopes("log2", {0}), Slopes{infinity});
  EXPECT_EQ(slopes("inversesqrt", {0}), Slopes{-infinity});
  EXPECT_EQ(slopes("atanh", {1}), Slopes{infinity});
  EXPECT_EQ(slope(1.0 / v[0], 0, {0}), -infinity);
}

}  // namespace
}  // namespace warpjet
