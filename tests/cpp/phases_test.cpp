// Phases: the arguments of waves and noises, at which a mesh is sampled finely enough; and kinks.
#include "eval/phases.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "bench.hpp"

namespace warpjet {
namespace {

// Waves of 2 * (x + u) - u / 3 and of x + u, in which only x varies.
TEST(Phases, LackWhatIsTheSameAtAllVertices) {
  Bench bench;
  const int u = bench.input("u"), sum = bench.call("add", {bench.x, u});
  const int twice = bench.call("mult", {sum, bench.number(2)});
  const int moving = bench.call("sub", {twice, bench.call("div", {u, bench.number(3)})});
  const int waves = bench.call("add", {bench.call("sin", {moving}), bench.call("cos", {sum})});
  bench.builder.output("gen", "result", waves);
  EXPECT_TRUE(bench.builder.finish()) << bench.builder.problem();
  Module module = load(save(bench.builder.module()));
  const std::uint32_t results[] = {0}, varying[] = {module.graph.findInput("x").value()};
  EXPECT_EQ(addPhases(module, results, varying).phases.size(), 2);
  Graph& graph = module.graph;
  const NodeId x = graph.component(varying[0], 0);
  const NodeId twiceX = graph.apply(ops::find("mult"), {x, graph.constant(2)});
  EXPECT_EQ(module.outputs.back().components, (std::vector<NodeId>{x, twiceX}));
}

// A result of x, and of the uniform u.
struct KinksFound : Bench {
  std::vector<Front> kinks(int value) {
    builder.output("gen", "result", value);
    EXPECT_TRUE(builder.finish()) << builder.problem();
    Module module = load(save(builder.module()));
    const std::uint32_t results[] = {0}, varying[] = {module.graph.findInput("x").value()};
    std::vector<Front> found = addPhases(module, results, varying).fronts;
    std::erase_if(found, [](const Front& front) { return !front.isKink(); });
    return found;
  }

  int u = input("u");
};

TEST(Kinks, AreWhereASlopeJumps) {
  const auto expectKinks = [](const char* op, std::vector<double> numbers,
                              const std::vector<Front>& expected) {
    KinksFound bench;
    std::vector<int> operands{bench.x};
    for (const double each : numbers) operands.push_back(bench.number(each));
    EXPECT_EQ(bench.kinks(bench.call(op, operands)), expected) << op;
  };
  expectKinks("abs", {}, {{Profile::Kink, 0, 1}});
  expectKinks("max", {0.5}, {{Profile::Kink, 0.5, 1}});
  expectKinks("clamp", {-2, 3}, {{Profile::Kink, -2, 1}, {Profile::Kink, 3, 1}});
  expectKinks("sqrt", {}, {{Profile::Cusp, 0, 1}});
  expectKinks("sin", {}, {});
}

TEST(Kinks, OfANumberThatAUniformChangesAreNotStill) {
  KinksFound bench;
  EXPECT_EQ(bench.kinks(bench.call("abs", {bench.call("sub", {bench.x, bench.u})})),
            (std::vector<Front>{{Profile::Kink, 0, 0}}));
}

// A step function of a uniform moves a kink, too.
TEST(Kinks, OfANumberThatStepsWithAUniformAreNotStill) {
  KinksFound bench;
  const int whole = bench.call("floor", {bench.u});
  EXPECT_EQ(bench.kinks(bench.call("abs", {bench.call("sub", {bench.x, whole})})),
            (std::vector<Front>{{Profile::Kink, 0, 0}}));
}

// The kink of abs is flattened where x is below 30.
TEST(Kinks, ThatAreFlattenedNearTheOriginAreFound) {
  KinksFound bench;
  const int ramp =
      bench.call("max", {bench.call("sub", {bench.x, bench.number(30)}), bench.number(0)});
  const int wave = bench.call("abs", {bench.call("sin", {bench.x})});
  EXPECT_EQ(bench.kinks(bench.call("mult", {ramp, wave})).size(), 2u);
}

// The jump of the slope is u / 200, against a slope of 1.
TEST(Kinks, ThatOnlyLargeUniformsShowAreFound) {
  KinksFound bench;
  const int slow = bench.call("mult", {bench.x, bench.number(0.0025)});
  const int kinked = bench.call("mult", {bench.call("abs", {slow}), bench.u});
  EXPECT_EQ(bench.kinks(bench.call("add", {bench.x, kinked})).size(), 1u);
}

TEST(Kinks, OfTwoNumbersAreWhereTheseAreEqual) {
  KinksFound bench;
  const int twice = bench.call("mult", {bench.x, bench.number(2)});
  EXPECT_EQ(bench.kinks(bench.call("min", {twice, bench.u})),
            (std::vector<Front>{{Profile::Kink, 0, 0}}));
}

TEST(Kinks, AreNotFoundWhereANumberOnlyReachesItsLimit) {
  KinksFound bench;
  const int square = bench.call("mult", {bench.x, bench.x});
  EXPECT_TRUE(bench.kinks(bench.call("max", {square, bench.number(0)})).empty());
  // A vector is tested like this before it is normalized.
  KinksFound choice;
  const int isNonzero =
      choice.call("gt", {choice.call("mult", {choice.x, choice.x}), choice.number(0)});
  EXPECT_TRUE(choice.kinks(choice.call("ifElse", {isNonzero, choice.x, choice.number(0)})).empty());
}

TEST(Kinks, ThatVanishInTheResultAreNotFound) {
  KinksFound square;
  const int ramp = square.call("max", {square.x, square.number(0)});
  EXPECT_TRUE(square.kinks(square.call("mult", {ramp, ramp})).empty());

  KinksFound step;
  const int numbers[] = {step.number(0.2), step.number(0.6)};
  EXPECT_TRUE(step.kinks(step.call("smoothstep", {numbers[0], numbers[1], step.x})).empty());

  // A circle that continues straight: sin(c) + (x - c) cos(c), for x limited to [-1, 1].
  KinksFound bend;
  const int c = bend.call("clamp", {bend.x, bend.number(-1), bend.number(1)});
  const int rest = bend.call("mult", {bend.call("sub", {bend.x, c}), bend.call("cos", {c})});
  EXPECT_TRUE(bend.kinks(bend.call("add", {bend.call("sin", {c}), rest})).empty());
}

}  // namespace
}  // namespace warpjet
