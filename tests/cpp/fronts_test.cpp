// Fronts: functions that change within a short part of their argument's range. Finds them in an
// offset, and cuts meshes at them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "bench.hpp"
#include "detail/front_scale.hpp"
#include "detail/quadratic_range.hpp"
#include "detail_support.hpp"
#include "eval/phases.hpp"

namespace warpjet {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Compares the range of random quadratics with their values at many points.
TEST(QuadraticRange, ContainsTheValuesAndNoMore) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 200; ++i) {
    double k[6];
    for (double& each : k) each = number(random);
    const auto at = [&](double u, double v) {
      return k[0] + k[1] * u + k[2] * v + k[3] * u * u + k[4] * u * v + k[5] * v * v;
    };
    const ValueRange range =
        rangeOnTriangle({at(0, 0), at(1, 0), at(0, 1)}, {at(0.5, 0), at(0.5, 0.5), at(0, 0.5)});
    const ValueRange along = rangeOnSegment(at(0, 0), at(0.5, 0), at(1, 0));
    ValueRange found, foundAlong;
    constexpr double steps = 200;
    for (double a = 0; a <= steps; ++a) {
      foundAlong.add(at(a / steps, 0));
      for (double b = 0; a + b <= steps; ++b) found.add(at(a / steps, b / steps));
    }
    for (const auto& [expected, actual] : {std::pair(found, range), {foundAlong, along}}) {
      EXPECT_NEAR(actual.low, expected.low, 1e-4);
      EXPECT_NEAR(actual.high, expected.high, 1e-4);
    }
  }
}

// Between numbers where a function hardly changes, the scale doesn't change either, however far
// apart they are.
TEST(FrontScale, ChangesWhereTheFunctionDoes) {
  const auto expectChanges = [](const Front& front, ValueRange onMesh, ValueRange steep,
                                ValueRange flat) {
    const FrontScale scale(front, onMesh, onMesh);
    EXPECT_GT(scale.changeWithin(steep), 1.9);
    EXPECT_LT(scale.changeWithin(flat), 0.5);
  };
  expectChanges({Profile::Step, 0, 1}, {-1000, 1000}, {0, 1}, {2, 1000});
  expectChanges({Profile::Step, 0, infinity}, {-1000, 2}, {0, 2}, {-1000, -1});
  expectChanges({Profile::Step, -infinity, 3}, {1, 1000}, {1, 3}, {4, 1000});
  expectChanges({Profile::Exponential, 1}, {-1000, 5}, {2, 5}, {-1000, 0.5});
  expectChanges({Profile::Exponential, -2}, {3, 1000}, {3, 5}, {6, 1000});
  expectChanges({Profile::Power, -1}, {0.001, 10}, {0.001, 0.01}, {0.1, 10});
  expectChanges({Profile::Power, 40}, {0, 2}, {1.8, 2}, {0, 1.7});
  expectChanges({Profile::Arctangent}, {-1e6, 1e6}, {-2, 2}, {150, 1e6});
}

// A power whose argument reaches 0 is a pole, which no mesh shows.
TEST(FrontScale, IgnoresPoles) {
  const ValueRange onMesh{0, 1};
  EXPECT_EQ(FrontScale({Profile::Power, -1}, onMesh, onMesh).changeWithin({0.1, 1}), 0);
}

struct FrontsFound : Bench {
  std::vector<Front> fronts(int value) {
    builder.output("gen", "result", value);
    EXPECT_TRUE(builder.finish()) << builder.problem();
    Module module = load(save(builder.module()));
    const std::uint32_t results[] = {0};
    std::vector<std::uint32_t> varying;
    for (std::uint32_t i = 0; i < module.graph.inputCount(); ++i) varying.push_back(i);
    std::vector<Front> found = addPhases(module, results, varying).fronts;
    EXPECT_EQ(module.outputs.back().components.size(), found.size());
    std::erase_if(found, [](const Front& front) { return front.isCrease(); });
    return found;
  }
};

TEST(Fronts, AreFoundByTheirOperations) {
  const auto expectFront = [](const char* op, const Front& expected) {
    FrontsFound bench;
    EXPECT_EQ(bench.fronts(bench.call(op, {bench.x})), std::vector{expected}) << op;
  };
  expectFront("exp", {Profile::Exponential, 1});
  expectFront("tanh", {Profile::Step, -3, 3});
  expectFront("atan", {Profile::Arctangent});
}

TEST(Fronts, OfLimitsAreStepsBetweenThem) {
  const auto expectFront = [](const char* op, std::vector<double> limits, const Front& expected) {
    FrontsFound bench;
    std::vector<int> operands{bench.x};
    for (const double limit : limits) operands.push_back(bench.number(limit));
    EXPECT_EQ(bench.fronts(bench.call(op, operands)), std::vector{expected}) << op;
  };
  expectFront("clamp", {0, 1}, {Profile::Step, 0, 1});
  expectFront("max", {0.5}, {Profile::Step, 0.5, infinity});
  expectFront("min", {0.5}, {Profile::Step, -infinity, 0.5});
  expectFront("pow", {40}, {Profile::Power, 40});
}

TEST(Fronts, OfASigmoidIsOneStepBesideTheExponential) {
  FrontsFound bench;
  const int sum = bench.call("add", {bench.call("exp", {bench.x}), bench.number(1)});
  const std::vector<Front> found = bench.fronts(bench.call("div", {bench.number(1), sum}));
  EXPECT_EQ(found, (std::vector<Front>{{Profile::Exponential, 1}, {Profile::Step, -6, 6}}));
}

TEST(Fronts, OfAChoiceAreOnTheSideThatVaries) {
  const auto expectFront = [](const char* comparison, bool isYes, const Front& expected) {
    FrontsFound bench;
    const int condition = bench.call(comparison, {bench.x, bench.number(0.5)});
    const int zero = bench.number(0);
    const int chosen = isYes ? bench.call("ifElse", {condition, bench.x, zero})
                             : bench.call("ifElse", {condition, zero, bench.x});
    EXPECT_EQ(bench.fronts(chosen), std::vector{expected}) << comparison;
  };
  expectFront("lt", true, {Profile::Step, -infinity, 0.5});
  expectFront("lt", false, {Profile::Step, 0.5, infinity});
  expectFront("gt", true, {Profile::Step, 0.5, infinity});
  expectFront("ge", false, {Profile::Step, -infinity, 0.5});
}

// Cuts the triangle (0, 0), (1, 0), (0, 1) until a front is fine enough everywhere.
template <class F>
Detail cutAt(const Front& front, F&& number) {
  Detail detail({{3, false, {0, 0, 0, 1, 0, 0, 0, 1, 0}}}, 1, {});
  detail.givenIndices() = {0, 1, 2};
  detail.begin();
  detail.setPhases({}, {}, {front});
  int passes = 0;
  do {
    std::vector<float>& numbers = detail.phases();
    const std::vector<float>& p = detail.samples()[0].values;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = number(p[3 * i], p[3 * i + 1]);
  } while (detail.cut(0.5f) && ++passes < 20);
  return detail;
}

// Returns the longest side of the cut triangle that contains a point.
float longestSideAt(const Detail& detail, float x, float y) {
  const std::vector<float>& p = detail.base().attributes()[0].values;
  for (const Corners& t : detail.base().triangles()) {
    bool isInside = true;
    float longest = 0;
    for (int i = 0; i < 3; ++i) {
      const float *a = &p[3 * t[i]], *b = &p[3 * t[(i + 1) % 3]];
      isInside = isInside && (b[0] - a[0]) * (y - a[1]) >= (b[1] - a[1]) * (x - a[0]);
      longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1]));
    }
    if (isInside) return longest;
  }
  return 0;
}

// The peak has the same number at all three corners, and at the middles of two sides.
TEST(Detail, CutsAtAPeakInsideOfATriangle) {
  for (const float sharpness : {1000.0f, 10'000.0f}) {
    const Detail detail = cutAt({Profile::Exponential, 1}, [&](float x, float y) {
      return -sharpness * ((x - 0.31f) * (x - 0.31f) + (y - 0.33f) * (y - 0.33f));
    });
    EXPECT_LT(longestSideAt(detail, 0.31f, 0.33f), 3 / std::sqrt(sharpness));
    EXPECT_GT(longestSideAt(detail, 0.9f, 0.05f), 0.1f);
    EXPECT_LT(detail.base().triangles().size(), 400u);
  }
}

TEST(Detail, CutsAlongAStepAndNotElsewhere) {
  const Detail detail = cutAt({Profile::Step, 0.4, 0.42}, [](float x, float) { return x; });
  // Within the step, no triangle contains more than half of it.
  for (const Corners& t : detail.base().triangles()) {
    float low = 1, high = 0;
    for (const std::uint32_t corner : t) {
      const float x = detail.base().attributes()[0].values[3 * corner];
      low = std::min(low, x);
      high = std::max(high, x);
    }
    const bool isInStep = low < 0.419f && high > 0.401f;
    EXPECT_TRUE(!isInStep || high - low < 0.5f * 0.02f * 1.12f) << low << " to " << high;
  }
  // Pieces of this length everywhere would be 10,000 triangles.
  EXPECT_LT(detail.base().triangles().size(), 1000u);
}

// Steps that are far narrower than a thousandth of the mesh would need millions of triangles.
TEST(Detail, LimitsTheCutsAtJumps) {
  const Detail detail =
      cutAt({Profile::Step, 0, 1}, [](float x, float y) { return 1e9f * (x * x + y * y - 0.3f); });
  EXPECT_LT(detail.base().triangles().size(), std::size_t{1} << 16);
}

TEST(Detail, IgnoresFrontsThatAreNotFinite) {
  const auto countTriangles = [](float number) {
    return cutAt({Profile::Exponential, 1}, [=](float, float) { return number; })
        .base()
        .triangles()
        .size();
  };
  EXPECT_EQ(countTriangles(NAN), countTriangles(0));
}

}  // namespace
}  // namespace warpjet
