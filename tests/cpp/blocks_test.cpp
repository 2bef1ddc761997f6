// Compares evaluation in blocks of vertices with the evaluation of single vertices in double, which
// program_test.cpp checks; and the allocation of registers with lifetimes determined by hand.
#include "eval/blocks.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "eval/program.hpp"
#include "ops/rows.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

class BlocksTest : public testing::Test {
 protected:
  Graph graph;
  Value p = vector3(graph, "position");
  Expression time = scalar(graph, "time");

  std::optional<Program> compiled;

  RegisterProgram registers(const std::vector<NodeId>& roots, bool timeIsUniform = true) {
    compiled = program(graph, roots);
    std::vector<std::uint32_t> wanted(roots.size());
    std::iota(wanted.begin(), wanted.end(), 0u);
    return allocateRegisters(compiled->words, compiled->instructions, wanted,
                             {false, false, false, timeIsUniform});
  }

  std::vector<float> run(const std::vector<NodeId>& roots, const std::vector<float>& positions,
                         float timeValue) {
    const Stream inputs[] = {{positions.data(), 3, false}, {&timeValue, 1, true}};
    const std::size_t vertices = positions.size() / 3;
    std::vector<float> results(vertices * roots.size());
    BlockEvaluator evaluator(registers(roots), inputs);
    const Sink sinks[] = {{results.data(), static_cast<std::uint32_t>(roots.size())}};
    evaluator.run(vertices, inputs, sinks);
    return results;
  }

  static std::vector<float> randomPositions(std::size_t vertices) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> number(-1, 1);
    std::vector<float> positions(3 * vertices);
    for (float& x : positions) x = number(random);
    return positions;
  }
};

// Samples each operation within its domain, where float and double agree.
TEST_F(BlocksTest, EveryRowHasTheValueOfTheTable) {
  std::mt19937 random(1);
  std::size_t i = 0;
  std::apply(
      [&](const auto&... row) {
        (
            [&] {
              const Op op{static_cast<std::uint8_t>(i++)};
              std::vector<float> positions;
              for (int vertex = 0; vertex < 257; ++vertex) {
                for (const auto [low, high] : row.domain)
                  positions.push_back(static_cast<float>(
                      std::uniform_real_distribution(std::min(low, high), high)(random)));
              }
              const NodeId result = graph.apply(op, {p[0].id, p[1].id, p[2].id});
              const NodeId number = graph.apply(rowNamed("add"), {result, graph.constant(0.25)});
              const std::vector<float> found = run({number}, positions, 0);
              for (std::size_t vertex = 0; vertex < found.size(); ++vertex) {
                const float* point = &positions[3 * vertex];
                Operands<double> x{};
                for (std::size_t k = 0; k < 3; ++k) {
                  const ops::Type type = ops::declaration(op).signature.operands[k];
                  x[k] = type == ops::Type::Bool  ? double(point[k] != 0)
                         : type == ops::Type::Int ? std::trunc(double{point[k]})
                                                  : double{point[k]};
                }
                const double expected = ops::valueOf(op, x) + 0.25;
                // The bits of some integers are those of NaN.
                if (std::isnan(expected) && std::isnan(found[vertex])) continue;
                ASSERT_NEAR(found[vertex], expected, 2e-6 * std::max(1.0, std::abs(expected)))
                    << row.name << "(" << point[0] << ", " << point[1] << ", " << point[2] << ")";
              }
            }(),
            ...);
      },
      ops::table);
}

// Floats can't represent all 32 bits: tests known, uniform and per-vertex integers.
TEST_F(BlocksTest, IntegersHave32Bits) {
  const auto apply = [&](std::string_view name, NodeId x, NodeId y = {}) {
    return graph.apply(rowNamed(name), {x, y});
  };
  const auto integer = [&](int value) {
    return graph.apply(rowNamed("int"), {graph.constant(value)});
  };
  // Combines two halves, as lowered shader source does: a float can't represent all 32 bits.
  const auto constantBits = [&](int value) {
    return apply("bitOr", apply("shiftLeft", integer(value >> 16), integer(16)),
                 integer(value & 65535));
  };
  const NodeId bits = apply("floatBitsToInt", p[0].id), timeBits = apply("floatBitsToInt", time.id);
  const NodeId mixed = apply("intMult", apply("bitXor", bits, timeBits), constantBits(2146121005));
  const NodeId low = apply("intToFloat", apply("bitAnd", mixed, constantBits(65535)));
  const NodeId high = apply("bitsToFloat", apply("bitsShiftRight", mixed, constantBits(16)));
  const NodeId same = apply("intBitsToFloat", bits);
  const std::vector<float> positions = randomPositions(37);
  const std::vector<float> found = run({low, high, same}, positions, 1.3f);
  for (std::size_t i = 0; i < 37; ++i) {
    const float x = positions[3 * i];
    const std::uint32_t expected =
        (__builtin_bit_cast(std::uint32_t, x) ^ __builtin_bit_cast(std::uint32_t, 1.3f)) *
        2146121005u;
    EXPECT_EQ(found[3 * i], static_cast<float>(expected & 65535));
    EXPECT_EQ(found[3 * i + 1], static_cast<float>(expected >> 16));
    EXPECT_EQ(found[3 * i + 2], x);
  }
}

// The numbers of vertices are near the width of a SIMD register, and near parts of a block.
TEST_F(BlocksTest, EvaluatesAnyNumberOfVertices) {
  const std::vector<NodeId> roots{(p[0] * 2.0 + time).id, (p[1] - p[2]).id};
  for (const std::size_t vertices : {0, 1, 2, 3, 4, 5, 7, 8, 9, 63, 64, 65, 255, 257, 1000}) {
    const std::vector<float> positions = randomPositions(vertices);
    const std::vector<float> found = run(roots, positions, 3);
    ASSERT_EQ(found.size(), 2 * vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
      EXPECT_EQ(found[2 * i], positions[3 * i] * 2 + 3);
      EXPECT_EQ(found[2 * i + 1], positions[3 * i + 1] - positions[3 * i + 2]);
    }
  }
}

// Some values are long-lived, some short-lived; they take more registers than fit into a block.
TEST_F(BlocksTest, RegistersPreserveValuesThatAreStillRead) {
  std::vector<Expression> early;
  for (int i = 0; i < 400; ++i) early.push_back(sin(p[i % 3] * (0.1 * i)));
  Expression sum = time;
  for (const Expression& x : early) sum = sum * 0.5 + x;
  for (const Expression& x : early) sum = sum * 0.5 - x * x;
  const std::vector<float> positions = randomPositions(100);
  const std::vector<float> found = run({sum.id, early[7].id}, positions, 0.5f);
  for (std::size_t i = 0; i < 100; ++i) {
    const Inputs inputs{{p[0].id, positions[3 * i]},
                        {p[1].id, positions[3 * i + 1]},
                        {p[2].id, positions[3 * i + 2]},
                        {time.id, 0.5}};
    EXPECT_NEAR(found[2 * i], evaluateNode(graph, sum.id, inputs), 1e-5);
    EXPECT_NEAR(found[2 * i + 1], evaluateNode(graph, early[7].id, inputs), 1e-6);
  }
}

TEST_F(BlocksTest, EvaluatesConditionsPerVertex) {
  const Expression chosen = ifElse(logicalAnd(lt(p[0], p[1]), gt(time, 0.0)), p[0], p[1] * 10.0);
  EXPECT_EQ(run({chosen.id}, {1, 2, 0, 2, 1, 0, 3, 3, 0}, 1), (std::vector<float>{1, 10, 30}));
  EXPECT_EQ(run({chosen.id}, {1, 2, 0}, 0), std::vector<float>{20});
}

TEST_F(BlocksTest, FreesARegisterAfterItsLastUse) {
  Expression chain = p[0];
  for (int i = 0; i < 1000; ++i) chain = sin(chain) * chain;
  const RegisterProgram allocated = registers({chain.id});
  EXPECT_EQ(allocated.blockRegisters, 2u) << "the chain, and its sine";
  EXPECT_EQ(allocated.body.size(), 2001u);
}

TEST_F(BlocksTest, ComputesValuesSharedByAllVerticesOnce) {
  const Expression shared = cos(time * 3.0) + 1.0;
  const RegisterProgram allocated = registers({(p[0] * shared).id});
  EXPECT_EQ(allocated.constants, (std::vector<float>{3, 1}));
  EXPECT_EQ(allocated.prologue.size(), 4u) << "time, product, cosine, sum";
  EXPECT_EQ(allocated.body.size(), 2u) << "position.x, product";
  EXPECT_EQ(registers({(p[0] * shared).id}, false).prologue.size(), 0u);
}

TEST_F(BlocksTest, ComputesOnlyTheRequestedResults) {
  const std::vector<NodeId> roots{sin(p[0]).id, cos(p[1]).id};
  compiled = program(graph, roots);
  const std::vector<bool> isUniform(4, false);
  const RegisterProgram second =
      allocateRegisters(compiled->words, compiled->instructions, std::array{1u}, isUniform);
  ASSERT_EQ(second.body.size(), 2u);
  EXPECT_EQ(second.body[0].input, 1u);
  EXPECT_EQ(second.body[1].op, rowNamed("cos"));
  EXPECT_EQ(second.results.size(), 1u);
}

TEST_F(BlocksTest, ResultsMayBeInputsConstantsOrRepeated) {
  const std::vector<NodeId> roots{p[1].id, graph.constant(7), p[1].id, time.id};
  EXPECT_EQ(run(roots, {1, 2, 3, 4, 5, 6}, 9), (std::vector<float>{2, 7, 2, 9, 5, 7, 5, 9}));
}

}  // namespace
}  // namespace warpjet
