// Tests that a new operation needs only a row in ops/table.hpp: this build adds three rows and
// changes nothing else. The expected numbers and code were written by hand.
#include <gtest/gtest.h>

#include "bench.hpp"
#include "eval/blocks.hpp"
#include "eval/bounds.hpp"
#include "eval/program.hpp"

namespace warpjet {
namespace {

class AddedOperation : public testing::Test, protected Bench {
 protected:
  int y = input("y");

  // Returns the program of a scalar result that depends on x, or on x and y.
  Program programOf(int result) {
    builder.output("gen", "result", result);
    EXPECT_TRUE(builder.finish()) << builder.problem();
    const Graph& graph = builder.graph();
    componentCount_ = 0;
    for (std::uint32_t i = 0; i < graph.inputCount(); ++i)
      componentCount_ += graph.input(i).shape.size();
    return *program(builder.module(), std::array{std::uint32_t{0}}).program;
  }

  // Returns values for all components of the inputs. The bench declares x first, and this fixture
  // declares y last, so x and y are at the ends.
  template <class Number>
  std::vector<Number> inputComponents(Number first, Number last, Number others = {}) const {
    std::vector<Number> all(componentCount_, others);
    all.back() = last;
    all.front() = first;
    return all;
  }

  double at(const Program& program, double first, double last = 0) const {
    double result = 0;
    evaluate(program.words, program.instructions, inputComponents(first, last), {&result, 1});
    return result;
  }

  std::vector<float> inLanes(const Program& program, const std::vector<float>& first,
                             const std::vector<float>& last) const {
    const float zero = 0;
    const std::vector<Stream> streams = inputComponents<Stream>(
        {first.data(), 1, false}, {last.data(), 1, last.empty()}, {&zero, 1, true});
    BlockEvaluator evaluator(
        allocateRegisters(program.words, program.instructions, std::array{std::uint32_t{0}},
                          std::vector<bool>(componentCount_)),
        streams);
    std::vector<float> results(first.size());
    evaluator.run(first.size(), streams, std::array{Sink{results.data(), 1}});
    return results;
  }

  Range boundsOf(const Program& program, Range first, Range last = {0, 0}) const {
    return bounds(program.words, program.instructions, inputComponents(first, last),
                  std::array{std::uint32_t{0}})[0];
  }

  static std::string writeModule(const Builder& from, const Dialect& dialect) {
    const ShaderTextResult written = write(from.module(), dialect);
    return written.text ? written.text->declarations + written.text->emitted.code : written.problem;
  }

 private:
  std::size_t componentCount_ = 0;  // of all inputs
};

TEST_F(AddedOperation, IsFoldedForConstantOperands) {
  EXPECT_EQ(text(call("cbrt", {number(-27)})), "-3.0");
}

TEST_F(AddedOperation, IsEvaluatedInDouble) { EXPECT_EQ(at(programOf(call("cbrt", {x})), 64), 4); }

TEST_F(AddedOperation, HasADerivative) {
  EXPECT_DOUBLE_EQ(at(programOf(call("derivative", {call("cbrt", {x}), x})), 8), 1.0 / 12);
}

TEST_F(AddedOperation, HasADerivativeWithRespectToEachOperand) {
  const Program slope = programOf(call("derivative", {call("hypot", {x, y}), y}));
  EXPECT_DOUBLE_EQ(at(slope, 3, 4), 0.8);
}

TEST_F(AddedOperation, HasAZeroDerivativeIfItDeclaresNoPartials) {
  EXPECT_EQ(text(call("derivative", {call("times", {x, y}), x})), "0.0");
}

TEST_F(AddedOperation, IsWrittenInEachLanguage) {
  builder.output("gen", "root", call("cbrt", {x}));
  builder.output("gen", "size", method("hypot", {x, y}));
  builder.output("gen", "count", call("times", {x, y}));
  const std::string webgl2 = writeModule(builder, glsl300), webgl = writeModule(builder, glsl100),
                    webgpu = writeModule(builder, wgsl);
  EXPECT_TRUE(webgl2.starts_with("highp float warpjetCbrt(highp float x) {")) << webgl2;
  EXPECT_TRUE(webgpu.starts_with("fn warpjetCbrt(x: f32) -> f32 {")) << webgpu;
  for (const std::string& each : {webgl2, webgpu}) {
    EXPECT_TRUE(each.find("root = warpjetCbrt(x);") != each.npos) << each;
    EXPECT_TRUE(each.find("count = round(x / y);") != each.npos) << each;
  }
  EXPECT_TRUE(webgl2.find("size = length(vec2(x, y));") != webgl2.npos) << webgl2;
  EXPECT_TRUE(webgpu.find("size = length(vec2f(x, y));") != webgpu.npos) << webgpu;
  // GLSL ES 1.00 lacks the functions: the rows are lowered.
  EXPECT_TRUE(webgl.find("root = sign(x) * pow(abs(x), 0.33333334);") != webgl.npos) << webgl;
  EXPECT_TRUE(webgl.find("count = floor(x / y + 0.5);") != webgl.npos) << webgl;
}

// The number of vertices is larger than the number of lanes, and not a multiple of it.
TEST_F(AddedOperation, IsEvaluatedLaneByLaneIfItsFunctionTakesDoubles) {
  const Program program = programOf(call("cbrt", {x}));
  EXPECT_EQ(inLanes(program, {-8, -1, 0, 1, 8, 27}, {}), (std::vector<float>{-2, -1, 0, 1, 2, 3}));
}

TEST_F(AddedOperation, WithTwoOperandsIsEvaluatedLaneByLaneIfItsFunctionTakesDoubles) {
  const Program program = programOf(call("times", {x, y}));
  EXPECT_EQ(inLanes(program, {7, 8, 9, 10, -7}, {2, 3, 4, 5, 1}),
            (std::vector<float>{4, 3, 2, 2, -7}));
}

TEST_F(AddedOperation, IsEvaluatedInAllLanesAtOnceIfItsFunctionIsATemplate) {
  const Program program = programOf(call("hypot", {x, y}));
  EXPECT_EQ(inLanes(program, {3, 5, 8, 7, 20}, {4, 12, 15, 24, 21}),
            (std::vector<float>{5, 13, 17, 25, 29}));
}

TEST_F(AddedOperation, IsBoundedByItsValuesAtTheEndsIfItIsIncreasing) {
  const auto [low, high] = boundsOf(programOf(call("cbrt", {x})), {-8, 27});
  EXPECT_LE(low, -2);
  EXPECT_GE(high, 3);
  EXPECT_NEAR(low, -2, 1e-4);
  EXPECT_NEAR(high, 3, 1e-4);
}

TEST_F(AddedOperation, IsBoundedByItsFormulaIfItsFunctionIsATemplate) {
  const auto [low, high] = boundsOf(programOf(call("hypot", {x, y})), {3, 6}, {4, 8});
  EXPECT_LE(low, 5);
  EXPECT_GE(high, 10);
  EXPECT_NEAR(low, 5, 1e-3);
  EXPECT_NEAR(high, 10, 1e-3);
}

TEST_F(AddedOperation, IsUnboundedIfNothingIsKnownAboutIt) {
  const auto [low, high] = boundsOf(programOf(call("times", {x, y})), {3, 6}, {4, 8});
  EXPECT_EQ(high, Interval::infinity);
  EXPECT_EQ(low, -Interval::infinity);
}

TEST_F(AddedOperation, FollowsItsDeclaredTraits) {
  EXPECT_EQ(text(call("hypot", {x, y, number(2)})), "length(vec2(length(vec2(x, y)), 2.0))");
  EXPECT_EQ(text(call("sub", {call("hypot", {x, y}), call("hypot", {y, x})})), "0.0");
  EXPECT_EQ(builder.shape(call("hypot", {m2, m2})), matrixOf(2, 2));
  EXPECT_LT(call("cbrt", {m2}), 0);
  EXPECT_LT(call("cbrt", {x, y}), 0);
  EXPECT_LT(call("times", {x, number(0)}), 0);
}

}  // namespace
}  // namespace warpjet
