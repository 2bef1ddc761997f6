// Bounds of programs, compared with dense samples of warps and of random expressions, in double and
// in float32.
#include "eval/bounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "algebra/vectors.hpp"
#include "eval/program.hpp"
#include "eval/words.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

using Warp = std::function<Value(const Value& position, Expression time)>;

Value vector(Expression x, Expression y, Expression z) {
  const std::array all{x, y, z};
  return fill(*x.graph, vectorOf(3), [&](int i) { return all[static_cast<std::size_t>(i)]; });
}

Expression clamp(Expression x, double low, double high) {
  Graph& graph = *x.graph;
  return {&graph,
          graph.apply(rowNamed("clamp"), {x.id, graph.constant(low), graph.constant(high)})};
}

struct Case {
  const char* name;
  double size;
  Warp warp;
};

Value rotateAboutY(const Value& p, Expression a) {
  return vector(p[0] * cos(a) - p[2] * sin(a), p[1], p[0] * sin(a) + p[2] * cos(a));
}

Value sines(const Value& p, Expression t, double f, double amplitude) {
  return vector(amplitude * sin(f * p[1] + t), amplitude * sin(f * p[2] + t + 2.0),
                amplitude * sin(f * p[0] + t + 4.0));
}

const std::vector<Case> cases{
    {"airplane twist", 100,
     [](const Value& p, Expression t) {
       const Expression a = 0.015 * p[0] * sin(t);
       return vector(p[0], p[1] * cos(a) - p[2] * sin(a), p[1] * sin(a) + p[2] * cos(a)) - p;
     }},
    {"twist by four turns", 100,
     [](const Value& p, Expression t) { return rotateAboutY(p, 0.12 * p[1] * sin(t)) - p; }},
    {"sine cube", 100, [](const Value& p, Expression t) { return sines(p, t, 0.035, 22); }},
    {"sine sphere", 1, [](const Value& p, Expression t) { return sines(p, t, 7, 0.13); }},
    {"stacked sines", 100,
     [](const Value& p, Expression t) {
       Value sum = sines(p, t, 0.02, 20);
       for (int i = 1; i < 8; ++i) sum = sum + sines(p + sum, t, 0.02 * (1 + i), 10.0 / i);
       return sum;
     }},
    {"nested sines", 1,
     [](const Value& p, Expression t) {
       Value q = p;
       for (int i = 0; i < 4; ++i) q = q + sines(q, t, 2.0, 0.3);
       return q - p;
     }},
    {"genie", 100,
     [](const Value& p, Expression t) {
       Graph& g = p.graph();
       const auto c = [&](double x) { return Expression{&g, g.constant(x)}; };
       const Value spout = vector(c(100), c(186), c(0)), above = vector(c(150), c(0), c(0));
       const Expression progress = 0.5 + 0.75 * sin(t);
       const Expression s = clamp((progress - length(p - spout) / 480.0) / 0.5, 0, 1);
       const Expression u = s * s * (3.0 - 2.0 * s), v = 1.0 - u;
       return p * (v * v) + above * (2.0 * u * v) + spout * (u * u) - p;
     }},
    {"spoon", 100,
     [](const Value& p, Expression t) {
       const Expression r = 1.0 / (0.0185 + 0.018 * sin(t));
       const Expression along = clamp(p[0] + 10.0, 0, 50), beyond = p[0] + 10.0 - along;
       const Expression a = along / r;
       return vector((r - p[1]) * sin(a) + beyond * cos(a) - 10.0,
                     r - (r - p[1]) * cos(a) + beyond * sin(a), p[2]) -
              p;
     }},
    {"bunny flatten", 100,
     [](const Value& p, Expression t) {
       const Expression zero{&p.graph(), p.graph().constant(0)};
       return vector(-p[0] * clamp(0.5 + 1.5 * sin(t), 0, 0.97), zero, zero);
     }},
    {"displaced plane", 0.5,
     [](const Value& p, Expression t) {
       const Expression zero{&p.graph(), p.graph().constant(0)};
       const Expression d = sqrt(p[0] * p[0] + p[1] * p[1] + 0.002);
       const Expression ripples = 0.06 * sin(26.0 * d - 3.0 * t) / (8.0 * d + 1.0);
       return vector(zero, zero, ripples + 0.05 * sin(5.0 * p[0] + t) * cos(4.0 * p[1]) - p[2]);
     }},
    {"bulge", 250,
     [](const Value& p, Expression t) {
       const Expression x = p[0] - 40.0, y = p[1] + 30.0, near = exp((x * x + y * y) / -16000.0);
       return vector(0.6 * near * x, 0.6 * near * y, 90.0 * near + 14.0 * sin(0.01 * p[0] + t));
     }},
    {"inflated to a sphere", 100,
     [](const Value& p, Expression t) {
       return (normalize(p) * 80.0 - p) * Value(clamp(0.5 + 0.5 * sin(t), 0, 1));
     }},
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range nothing{infinity, -infinity};

void extend(Range& range, double value) {
  range.low = std::min(range.low, value);
  range.high = std::max(range.high, value);
}

double extent(const Range& range) { return range.high - range.low; }

// Returns the ranges of a program's results on a grid over the first three inputs.
std::array<Range, 3> sampleRange(const Program& program, double size, double time, int n) {
  std::array<Range, 3> found{nothing, nothing, nothing};
  const auto coordinate = [&](int i) { return size * (2.0 * i / n - 1); };
  std::array<double, 3> results;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      for (int k = 0; k <= n; ++k) {
        evaluate(program.words, program.instructions,
                 std::array{coordinate(i), coordinate(j), coordinate(k), time}, results);
        for (std::size_t axis = 0; axis < 3; ++axis) extend(found[axis], results[axis]);
      }
    }
  }
  return found;
}

class BoundsOfWarp : public testing::TestWithParam<Case> {};

TEST_P(BoundsOfWarp, ContainTheSamplesAndAreClose) {
  const auto& [name, size, warp] = GetParam();
  for (const double time : {0.7, 1.9, 5.0}) {
    Graph graph;
    const Value p = vector3(graph, "position");
    const Value warped = p + warp(p, scalar(graph, "time"));
    const auto compiled = program(graph, warped.nodes());
    ASSERT_TRUE(compiled);
    const Range inputs[] = {{-size, size}, {-size, size}, {-size, size}, {time, time}};
    const auto outer =
        bounds(compiled->words, compiled->instructions, inputs, std::array{0u, 1u, 2u});
    const auto inner = sampleRange(*compiled, size, time, 32);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_LE(outer[axis].low, inner[axis].low);
      EXPECT_GE(outer[axis].high, inner[axis].high);
      EXPECT_LE(extent(outer[axis]), 1.3 * extent(inner[axis])) << axis << " at " << time;
    }
  }
}

std::string nameOf(const testing::TestParamInfo<Case>& test) {
  std::string name = test.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Gallery, BoundsOfWarp, testing::ValuesIn(cases), nameOf);

class BoundsTest : public testing::Test {
 protected:
  Graph graph;
  Value p = vector3(graph, "position");
  Expression time = scalar(graph, "time");

  Range boundsOf(Expression f, const std::vector<Range>& inputs,
                 const BoundsOptions& options = {}) {
    const auto compiled = program(graph, std::array{f.id});
    EXPECT_TRUE(compiled);
    return bounds(compiled->words, compiled->instructions, inputs, std::array{0u}, options)[0];
  }
  // Returns the bounds for positions from -2 to 2 at time 0.
  Range boundsInBox(Expression f, const BoundsOptions& options = {}) {
    return boundsOf(f, {{-2, 2}, {-2, 2}, {-2, 2}, {0, 0}}, options);
  }
  static void expectNear(const Range& range, double low, double high, double error) {
    EXPECT_LE(range.low, low);
    EXPECT_GE(range.high, high);
    EXPECT_NEAR(range.low, low, error);
    EXPECT_NEAR(range.high, high, error);
  }
};

TEST_F(BoundsTest, AreExactForLinearExpressions) {
  expectNear(boundsInBox(p[0] + p[1] * 3.0), -8, 8, 1e-3);
  expectNear(boundsInBox({&graph, graph.constant(7)}), 7, 7, 1e-3);
  expectNear(boundsInBox(time), 0, 0, 1e-3);
}

TEST_F(BoundsTest, AreTightenedBySplittingTheBox) {
  expectNear(boundsInBox(p[0] * p[0] * p[0] * (1.0 - p[0])), -24, 27.0 / 256, 0.6);
  expectNear(boundsInBox(p[0] * (p[1] - p[0])), -8, 1, 0.25);
}

TEST_F(BoundsTest, AreThoseOfIntervalArithmeticWithoutBudget) {
  expectNear(boundsInBox(p[0] * (1.0 - p[0]), {.tolerance = 0, .budget = 0}), -6, 6, 1e-3);
}

// Running the program once costs 3: the difference, the product and the result. Running it for the
// whole box and two of its corners takes 9; splitting the box for either bound takes more.
TEST_F(BoundsTest, SpendTheBudgetOnRangesAndOnSamples) {
  const Expression f = p[0] * (1.0 - p[0]);
  expectNear(boundsInBox(f, {.tolerance = 0, .budget = 9}), -6, 6, 1e-3);
  EXPECT_LT(extent(boundsInBox(f, {.tolerance = 0, .budget = 11})), 11.9);
}

TEST_F(BoundsTest, AreNeverWiderWithMoreBudget) {
  const Expression f = sin(p[0] * p[1]) * (p[2] - p[0] * cos(p[2] * p[1]));
  double last = infinity;
  for (const std::uint64_t budget : {0u, 1000u, 10'000u, 100'000u, 1'000'000u}) {
    const double current = extent(boundsInBox(f, {.tolerance = 0, .budget = budget}));
    EXPECT_LE(current, last * (1 + 1e-12));
    last = current;
  }
}

TEST_F(BoundsTest, IgnoreTermsThatCancel) {
  expectNear(boundsInBox(p[0] + (sin(p[1]) - p[0]), {.tolerance = 0, .budget = 0}), -1, 1, 1e-3);
  expectNear(boundsInBox(p[0] * 5.0 - (p[0] * 4.0 + p[1])), -4, 4, 1e-3);
}

TEST_F(BoundsTest, ComponentsOfAUnitVectorAreAtMostOne) {
  for (const int axis : {0, 1, 2}) {
    expectNear(boundsInBox(normalize(p)[axis]), -1, 1, 0.05);
    expectNear(boundsInBox(p[axis] / length(p)), -1, 1, 0.05);
  }
  expectNear(boundsInBox((normalize(p) * p)[1]), 0, 2, 0.1);
}

TEST_F(BoundsTest, AreExactForSmoothstep) {
  const Expression s = clamp(p[0], 0, 1);
  for (const Expression smooth : {s * s * (3.0 - 2.0 * s), s * s * (s * -2.0 + 3.0)})
    expectNear(boundsInBox(smooth, {.tolerance = 0, .budget = 0}), 0, 1, 1e-3);
}

TEST_F(BoundsTest, AreInfiniteAtAPole) {
  const Range range = boundsInBox(1.0 / (p[0] - 0.3));
  EXPECT_EQ(range.low, -infinity);
  EXPECT_EQ(range.high, infinity);
}

TEST_F(BoundsTest, FollowFloat32ToOverflowAndUnderflow) {
  const Expression x = p[0] * 100.0;
  EXPECT_EQ(boundsInBox(cosh(x)).high, infinity);
  EXPECT_GE(boundsInBox(ifElse(gt(exp(x), 0.0), 0.0, 100.0) - x).high, 300);
  EXPECT_LE(boundsInBox(sign(1.0 / cosh(x)) * 50.0 - x).low, -200);
  EXPECT_EQ(boundsInBox(p[0] * 1e30 * p[1] * 1e30).high, infinity);
  EXPECT_EQ(boundsInBox(p[0] * 2e38 + p[1] * 2e38).high, infinity);
  EXPECT_LE(boundsInBox((p[0] + 3.0) * 1e-30 * (p[1] + 3.0) * 1e-20).low, 0);
}

TEST_F(BoundsTest, AreEmptyIfEveryValueIsNaN) {
  const Range range = boundsInBox(sqrt(p[0] - 5.0));
  EXPECT_GT(range.low, range.high);
}

TEST_F(BoundsTest, IgnorePointsWhereTheValueIsNaN) {
  expectNear(boundsInBox(sqrt(p[0] - 1.0)), 0, 1, 0.05);
}

TEST_F(BoundsTest, AcceptInfiniteAndNaNInputs) {
  const Range all{-infinity, infinity}, none{NAN, NAN};
  expectNear(boundsOf(sin(p[0]) + p[1], {all, {-2, 2}, {0, 0}, {0, 0}}), -3, 3, 0.05);
  expectNear(boundsOf(clamp(p[0], 0, 1), {none, {0, 0}, {0, 0}, {0, 0}}), 0, 1, 0.05);
  EXPECT_EQ(boundsOf(p[0] + p[1], {none, {0, 1}, {0, 0}, {0, 0}}).high, infinity);
  expectNear(boundsOf(p[1] * 2.0, {none, {0, 1}, {0, 0}, {0, 0}}), 0, 2, 0.05);
}

TEST_F(BoundsTest, AreDeterministic) {
  const Expression f = sin(p[0] * p[1]) * (p[2] - p[0] * cos(p[2] * p[1]));
  const Range first = boundsInBox(f), second = boundsInBox(f);
  EXPECT_EQ(first.low, second.low);
  EXPECT_EQ(first.high, second.high);
}

TEST_F(BoundsTest, StopAtTheBudgetInALongProgram) {
  Expression f = p[0];
  for (int i = 0; i < 30'000; ++i) f = sin(f * 1.5 + p[1]);
  const Range range = boundsInBox(f);
  EXPECT_LE(range.low, -0.9);
  EXPECT_GE(range.high, 0.9);
}

// Returns the result of a program. If `Number` is float, each operation is rounded to float32.
template <class Number>
double evaluateRounded(const Program& program, std::span<const double> inputs) {
  const Words words(program.words, program.instructions);
  std::vector<double> values(words.count());
  for (std::uint32_t i = 0; i < words.count(); ++i) {
    double value;
    if (words.op(i) == constantOp) {
      value = words.constant(i);
    } else if (words.op(i) == inputOp) {
      value = inputs[words.input(i)];
    } else {
      Operands<double> x{};
      for (std::size_t k = 0; k < words.operands(i).size(); ++k)
        x[k] = values[words.operands(i)[k]];
      value = ops::valueOf(words.op(i), x);
    }
    const auto row = static_cast<std::size_t>(words.op(i));
    const bool isInt =
        row < ops::count && ops::declarations[row].signature.result == ops::Type::Int;
    values[i] = isInt ? value : static_cast<Number>(value);
  }
  return values[words.result(0)];
}

// Applies random rows to random earlier nodes; the graph converts conditions and numbers.
NodeId randomExpression(Graph& graph, const Value& p, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  std::vector<NodeId> nodes(p.nodes().begin(), p.nodes().end());
  for (const double constant : {0.0, 1.0, -0.7, 2.5, 1e-3, 40.0})
    nodes.push_back(graph.constant(constant));
  for (int i = 0; i < 16; ++i) {
    const Op op{static_cast<std::uint8_t>(below(ops::count))};
    const auto any = [&] { return nodes[below(2) ? below(nodes.size()) : nodes.size() - 1]; };
    const NodeId first = any(), second = any(), third = any();
    nodes.push_back(graph.apply(op, {first, second, third}));
  }
  return graph.apply(rowNamed("add"), {nodes.back(), p[0].id});
}

TEST(Bounds, ContainTheSamplesOfRandomExpressions) {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  int finiteCount = 0;
  for (int expression = 0; expression < 3000; ++expression) {
    Graph graph;
    const Value p = vector3(graph, "position");
    const auto compiled = program(graph, std::array{randomExpression(graph, p, random)});
    ASSERT_TRUE(compiled);
    std::vector<Range> inputs(3);
    for (Range& range : inputs) {
      range.low = static_cast<float>(between(-3, 3));
      range.high = range.low + (random() % 4 ? static_cast<float>(between(0, 4)) : 0);
    }
    const BoundsOptions options{.tolerance = 0.02, .budget = 20'000};
    const Range range =
        bounds(compiled->words, compiled->instructions, inputs, std::array{0u}, options)[0];
    finiteCount += std::isfinite(range.low) && std::isfinite(range.high);
    for (int sample = 0; sample < 300; ++sample) {
      std::array<double, 3> point;
      for (std::size_t i = 0; i < 3; ++i) {
        const double t = std::array{0.0, 1.0, between(0, 1), between(0, 1)}[random() % 4];
        point[i] = static_cast<float>(inputs[i].low * (1 - t) + inputs[i].high * t);
        point[i] = std::clamp(point[i], inputs[i].low, inputs[i].high);
      }
      for (const double value :
           {evaluateRounded<double>(*compiled, point), evaluateRounded<float>(*compiled, point)}) {
        if (!std::isfinite(value)) continue;
        ASSERT_TRUE(range.low <= value && value <= range.high)
            << "expression " << expression << " is " << value << ", not from " << range.low
            << " to " << range.high;
      }
    }
  }
  EXPECT_GT(finiteCount, 1500) << "most bounds must be finite";
}

}  // namespace
}  // namespace warpjet
