// The estimated cost of results, which decides where normals are computed.
#include "eval/cost.hpp"

#include <gtest/gtest.h>

#include "bench.hpp"
#include "noise/table.hpp"

namespace warpjet {
namespace {

struct Costs : Bench {
  int noise(const Noise& kind, int point) {
    builder.push(point);
    return builder.callNoise(kind, false);
  }

  Cost costOfResult(int value) {
    builder.output("gen", "result", value);
    EXPECT_TRUE(builder.finish()) << builder.problem();
    const std::uint32_t results[] = {0};
    return costOf(load(save(builder.module())), results);
  }
};

const Noise simplex{noiseNamed("simplex")};

double fbm(int octaves) {
  Costs costs;
  const Noise kind{noiseNamed("fbm"), noiseNamed("noise"), octaves};
  return costs.costOfResult(costs.noise(kind, costs.v3)).operations;
}

TEST(Cost, CountsAnOperationOnceHoweverOftenItIsRead) {
  Costs costs;
  const int sine = costs.call("sin", {costs.x});
  const auto [operations, hasNoise, needsGpu] =
      costs.costOfResult(costs.call("mult", {sine, sine}));
  EXPECT_EQ(operations, 2);
  EXPECT_FALSE(hasNoise || needsGpu);
}

TEST(Cost, CountsTheBodyOfAFunctionAtEachCall) {
  Costs one, two;
  const Cost once = one.costOfResult(one.noise(simplex, one.v3));
  const int doubled = two.call("mult", {two.v3, two.number(2)});
  const Cost twice =
      two.costOfResult(two.call("add", {two.noise(simplex, two.v3), two.noise(simplex, doubled)}));
  // Three products and a sum are outside of both calls.
  EXPECT_EQ(twice.operations, 2 * once.operations + 4);
  EXPECT_TRUE(once.hasNoise);
}

TEST(Cost, CountsALoopByItsSteps) { EXPECT_NEAR((fbm(8) - fbm(4)) / (fbm(4) - fbm(2)), 2, 1e-9); }

TEST(Cost, IncludesDerivativesOfNoise) {
  Costs value, slope;
  const double valueCost = value.costOfResult(value.noise(simplex, value.v3)).operations;
  const int gradient = slope.call("gradient", {slope.noise(simplex, slope.v3), slope.v3});
  EXPECT_GT(slope.costOfResult(gradient).operations, valueCost);
}

}  // namespace
}  // namespace warpjet
