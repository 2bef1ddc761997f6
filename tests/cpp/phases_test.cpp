// Phases: the arguments of waves and noises, at which a mesh is sampled finely enough; and kinks.
#include "eval/phases.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "bench.hpp"
#include "functions/fold.hpp"
#include "support.hpp"

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

TEST(Phases, IncludeTheNormalThatAResultReads) {
  const auto countPhases = [](bool readsNormal) {
    Bench bench;
    const int position = bench.input("position", vectorOf(3));
    const int normal = bench.input("normal", vectorOf(3));
    bench.builder.output("gen", "result", readsNormal ? normal : position);
    EXPECT_TRUE(bench.builder.finish()) << bench.builder.problem();
    Module module = load(save(bench.builder.module()));
    const std::uint32_t results[] = {0};
    const std::uint32_t varying[] = {module.graph.findInput("position").value(),
                                     module.graph.findInput("normal").value()};
    return addPhases(module, results, varying).phases.size();
  };
  EXPECT_EQ(countPhases(true), 1);
  EXPECT_EQ(countPhases(false), 0);
}

// Each step of the loop adds a wave of another length.
TEST(Phases, AreFoundInLoops) {
  Module module;
  Graph& graph = module.graph;
  const Expression x = scalar(graph, "x"), zero{&graph, graph.constant(0)};
  const Expression sum = fold(3, {zero}, [&](const Numbers& s, Expression i) {
    return Numbers{s[0] + sin(x * (i + 1.0))};
  })[0];
  module.outputs.push_back({.name = "result", .shape = {}, .components = {sum.id}});
  const std::uint32_t results[] = {0}, varying[] = {graph.findInput("x").value()};
  EXPECT_EQ(addPhases(module, results, varying).phases.size(), 3);
}

// A result of x, and of the uniform u.
struct KinksFound : Bench {
  std::vector<Front> kinks(int value, const std::vector<const char*>& varyingInputs = {"x"}) {
    builder.output("gen", "result", value);
    EXPECT_TRUE(builder.finish()) << builder.problem();
    Module module = load(save(builder.module()));
    const std::uint32_t results[] = {0};
    std::vector<std::uint32_t> varying;
    for (const char* name : varyingInputs) varying.push_back(module.graph.findInput(name).value());
    std::vector<Front> found = addPhases(module, results, varying).fronts;
    std::erase_if(found, [](const Front& front) { return !front.isCrease(); });
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

// The kink of abs is used only if u is negative, or zero.
TEST(Kinks, ThatOnlySomeUniformsShowAreFound) {
  KinksFound negative;
  const int slope = negative.call(
      "max", {negative.call("mult", {negative.u, negative.number(-1)}), negative.number(0)});
  EXPECT_EQ(
      negative.kinks(negative.call("mult", {negative.call("abs", {negative.x}), slope})).size(),
      1u);
  KinksFound zero;
  const int isPositive = zero.call("gt", {zero.call("abs", {zero.u}), zero.number(0.4)});
  const int choice = zero.call("ifElse", {isPositive, zero.x, zero.call("abs", {zero.x})});
  EXPECT_EQ(zero.kinks(choice).size(), 1u);
}

// The kink of abs is damped by exp(-k y^2).
TEST(Kinks, ThatAreSeenOnlyCloseToAnAxisAreFound) {
  for (const double k : {100.0, 1000.0, 3000.0}) {
    KinksFound bench;
    const int y = bench.input("y"), square = bench.call("mult", {y, y});
    const int damping = bench.call("exp", {bench.call("mult", {square, bench.number(-k)})});
    const int kinked = bench.call("mult", {bench.call("abs", {bench.x}), damping});
    EXPECT_EQ(bench.kinks(bench.call("add", {bench.x, kinked}), {"x", "y"}).size(), 1u) << k;
  }
}

TEST(Kinks, OfRootsThatAreNeverZeroAreNotFound) {
  KinksFound bench;
  const int square = bench.call("mult", {bench.x, bench.x});
  EXPECT_TRUE(
      bench.kinks(bench.call("sqrt", {bench.call("add", {square, bench.number(1)})})).empty());
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
