// Evaluation on the CPU: compares programs with evaluateNode and with numbers computed by hand.
#include "eval/program.hpp"

#include <gtest/gtest.h>

#include <random>

#include "diff/differentiator.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

class ProgramTest : public testing::Test {
 protected:
  Graph graph;
  Value p = vector3(graph, "position");
  Expression time = scalar(graph, "time");
  Value m = variable(graph, "m", matrixOf(2, 3));

  // Takes up to ten input numbers: those of p, time and m. Omitted ones are 0.
  static std::vector<double> run(const Program& program, std::vector<double> numbers,
                                 std::size_t count) {
    numbers.resize(10);
    std::vector<double> results(count);
    evaluate(program.words, program.instructions, numbers, results);
    return results;
  }
};

TEST_F(ProgramTest, ReturnsTheRootsInOrder) {
  const std::vector<NodeId> roots{(p[0] + p[1]).id, p[2].id, graph.constant(7), (p[0] + p[1]).id};
  const auto compiled = program(graph, roots);
  ASSERT_TRUE(compiled);
  EXPECT_EQ(run(*compiled, {1.0, 2.0, 5.0}, 4), (std::vector<double>{3, 5, 7, 3}));
}

TEST_F(ProgramTest, ReadsInputsInOrderAndMatricesColumnByColumn) {
  const std::vector<NodeId> roots{p[1].id, time.id, m.at(1, 0).id, m.at(0, 2).id};
  const std::vector<double> numbers{30, 31, 32, 20, 10, 11, 12, 13, 14, 15};
  const auto compiled = program(graph, roots);
  ASSERT_TRUE(compiled);
  EXPECT_EQ(run(*compiled, numbers, 4), (std::vector<double>{31, 20, 13, 12}));
}

TEST_F(ProgramTest, ReturnsConditionsAsOneOrZero) {
  const std::vector<NodeId> roots{lt(p[0], p[1]).id, gt(p[0], p[1]).id};
  const auto compiled = program(graph, roots);
  ASSERT_TRUE(compiled);
  EXPECT_EQ(run(*compiled, {1.0, 2.0, 0.0}, 2), (std::vector<double>{1, 0}));
}

TEST_F(ProgramTest, PreservesEveryBitOfConstants) {
  const std::vector<double> values{0.1, -1e-30, 98765.4321, 3e38};
  std::vector<NodeId> roots;
  for (const double value : values) roots.push_back(graph.constant(value));
  const auto compiled = program(graph, roots);
  ASSERT_TRUE(compiled);
  EXPECT_EQ(run(*compiled, {}, 4), values);
}

TEST_F(ProgramTest, HasOneInstructionForEachNode) {
  const Expression shared = sin(p[0]);
  const std::vector<NodeId> roots{(shared * shared + shared).id};
  const auto compiled = program(graph, roots);
  ASSERT_TRUE(compiled);
  EXPECT_EQ(compiled->instructions, 4u) << "p.x, sin, product, sum";
  EXPECT_EQ(compiled->words.size(), 4u * 4 + 1);
}

TEST_F(ProgramTest, DoesNotExistForACallOfAHostFunction) {
  const std::uint32_t noise = graph.addFunction({"noise", 2});
  const NodeId arguments[] = {p[0].id, p[1].id};
  const Expression call{&graph, graph.call(noise, arguments)};
  EXPECT_FALSE(program(graph, std::array{(call * 2.0).id}));
  EXPECT_TRUE(program(graph, std::array{p[0].id})) << "no root needs the call";
}

// The derivative of a call needs only its partial, not the call.
TEST_F(ProgramTest, ExistsForADerivativeThatNeedsNoCall) {
  const std::uint32_t linear = graph.addFunction({"linear", 1});
  const NodeId call = graph.call(linear, std::array{p[0].id});
  graph.setPartials(call, std::array{(p[0] * 3.0).id});
  Differentiator differentiator(graph);
  const NodeId slope = differentiator.derivative(call, p[0].id);
  const auto compiled = program(graph, std::array{slope});
  ASSERT_TRUE(compiled);
  EXPECT_EQ(run(*compiled, {2.0, 0.0, 0.0}, 1), std::vector<double>{6});
}

// Applies each row to the result of the previous one, and differentiates the result.
TEST_F(ProgramTest, MatchesTheEvaluationOfTheGraph) {
  std::vector<NodeId> roots;
  Differentiator differentiator(graph);
  NodeId last = time.id;
  for (std::size_t i = 0; i < ops::count; ++i) {
    const Op op{static_cast<std::uint8_t>(i)};
    last = graph.apply(op, {graph.apply(rowNamed("sin"), {last}), p[1].id, m[5].id});
    roots.push_back(last);
    roots.push_back(differentiator.derivative(last, p[1].id));
  }
  const auto compiled = program(graph, roots);
  ASSERT_TRUE(compiled);

  std::mt19937 random(1);
  for (int point = 0; point < 20; ++point) {
    std::vector<double> numbers;
    Inputs inputs;
    for (const Value& value : {p, Value(time), m}) {
      for (const NodeId id : value.nodes()) {
        numbers.push_back(std::uniform_real_distribution(-1.0, 1.0)(random));
        inputs[id] = numbers.back();
      }
    }
    const auto results = run(*compiled, numbers, roots.size());
    const auto values = evaluateNodes(graph, roots, inputs);
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const double expected = values.at(roots[i]);
      if (std::isnan(expected)) {
        EXPECT_TRUE(std::isnan(results[i])) << "root " << i;
      } else {
        EXPECT_EQ(results[i], expected) << "root " << i;
      }
    }
  }
}

TEST_F(ProgramTest, HandlesALongChainWithoutRecursion) {
  Expression f = time;
  for (int i = 0; i < 100'000; ++i) f = f * 0.5 + 1.0;
  const auto compiled = program(graph, std::array{f.id});
  ASSERT_TRUE(compiled);
  EXPECT_NEAR(run(*compiled, {0, 0, 0, 100}, 1)[0], 2, 1e-12);
}

}  // namespace
}  // namespace warpjet
