// Functions of the host: calls, declarations, and their partial derivatives.
#include <gtest/gtest.h>

#include "bench.hpp"
#include "eval/program.hpp"

namespace warpjet {
namespace {

class HostFunctions : public testing::Test, protected Bench {
 protected:
  // Returns the calls whose partials are needed for the derivative of this value.
  std::vector<NodeId> pendingFor(int value) {
    EXPECT_EQ(call("derivative", {value, x}), Builder::needsPartials);
    return builder.pendingCalls();
  }

  int noise = hostFunction("noise", "float noise(float a, float b) { return a * b; }", 2);
  int bump = hostFunction("bump", "float bump(float a) { return a; }", 1);
};

TEST_F(HostFunctions, AreCalledPerComponent) {
  const int called = callFunction(noise, {v3, x});
  EXPECT_EQ(builder.shape(called), vectorOf(3));
  EXPECT_EQ(text(called), "vec3(noise(v3.x, x), noise(v3.y, x), noise(v3.z, x))");
}

TEST_F(HostFunctions, ReceiveConditionsAsNumbers) {
  EXPECT_EQ(text(callFunction(bump, {call("lt", {x, number(1)})})), "bump(float(x < 1.0))");
}

TEST_F(HostFunctions, AreDeclaredOnceIfCalled) {
  const int a = callFunction(bump, {x}), b = callFunction(bump, {call("sin", {x})});
  builder.output("gen", "y", call("add", {a, b}));
  EXPECT_EQ(writeResults().text->declarations, "float bump(float a) { return a; }\n");
}

TEST_F(HostFunctions, NeedPartialsIfTheyAreDifferentiated) {
  const int called = callFunction(noise, {call("sin", {x}), x});
  const std::vector<NodeId> pendingCalls = pendingFor(called);
  ASSERT_EQ(pendingCalls.size(), 1u);
  const NodeId pending = pendingCalls[0];
  EXPECT_EQ(builder.functionOfCall(pending), noise);
  const int a = builder.argumentOfCall(pending, 0), b = builder.argumentOfCall(pending, 1);
  ASSERT_TRUE(givePartials(pending, {b, a}));
  const int slope = call("derivative", {called, x});
  ASSERT_GE(slope, 0) << builder.problem();
  EXPECT_EQ(text(slope), "x * cos(x) + sin(x)") << "chain rule with d/da = b, d/db = a";
}

TEST_F(HostFunctions, EqualCallsNeedTheirPartialsOnce) {
  const int called = callFunction(bump, {x}), again = callFunction(bump, {x});
  const std::vector<NodeId> pending = pendingFor(call("add", {called, again}));
  ASSERT_EQ(pending.size(), 1u);
  ASSERT_TRUE(givePartials(pending[0], {number(2)}));
  EXPECT_EQ(text(call("derivative", {again, x})), "2.0");
}

TEST_F(HostFunctions, DifferentCallsNeedTheirOwnPartials) {
  const int inner = callFunction(noise, {x, x});
  const int sum = call("add", {callFunction(bump, {x}), callFunction(bump, {inner})});
  const std::vector<NodeId> pending = pendingFor(sum);
  EXPECT_EQ(pending.size(), 3u);
  for (const NodeId call : pending) {
    if (builder.functionOfCall(call) == noise) {
      ASSERT_TRUE(givePartials(call, {number(3), number(5)}));
    } else {
      ASSERT_TRUE(givePartials(call, {builder.argumentOfCall(call, 0)}));
    }
  }
  EXPECT_EQ(text(call("derivative", {sum, x})), "x + noise(x, x) * 8.0");
}

TEST_F(HostFunctions, ASecondDerivativeNeedsThePartialsOfThePartials) {
  const int called = callFunction(bump, {x});
  const std::vector<NodeId> pending = pendingFor(called);
  ASSERT_EQ(pending.size(), 1u);
  const NodeId first = pending[0];
  const int steepness = hostFunction("steepness", "float steepness(float a) { return 1.0; }", 1);
  ASSERT_TRUE(givePartials(first, {callFunction(steepness, {builder.argumentOfCall(first, 0)})}));
  const int slope = call("derivative", {called, x});
  const std::vector<NodeId> pendingAgain = pendingFor(slope);
  ASSERT_EQ(pendingAgain.size(), 1u);
  const NodeId second = pendingAgain[0];
  EXPECT_EQ(builder.functionOfCall(second), steepness);
  const int argument = builder.argumentOfCall(second, 0);
  ASSERT_TRUE(givePartials(second, {call("mult", {argument, number(6)})}));
  const int curvature = call("derivative", {slope, x});
  builder.output("gen", "slope", slope);
  builder.output("gen", "curvature", curvature);
  const auto text = writeResults().text;
  ASSERT_TRUE(text) << problemOfText();
  EXPECT_EQ(text->emitted.code,
            "float slope, curvature;\n{\n  slope = steepness(x);\n  curvature = x * 6.0;\n}\n");
  EXPECT_EQ(text->declarations, "float steepness(float a) { return 1.0; }\n")
      << "bump is not called";
}

TEST_F(HostFunctions, GradientsJacobiansAndNormalsNeedPartialsToo) {
  const int offset = callFunction(bump, {v3}), normal = input("normal", vectorOf(3));
  EXPECT_EQ(call("adjustNormal", {offset, normal, v3}), Builder::needsPartials);
  EXPECT_EQ(call("gradient", {call("length", {offset}), v3}), Builder::needsPartials);
  ASSERT_EQ(call("jacobian", {offset, v3}), Builder::needsPartials);
  const std::vector<NodeId> pending = builder.pendingCalls();
  ASSERT_EQ(pending.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    ASSERT_TRUE(givePartials(pending[i], {number(static_cast<double>(i))}));
  EXPECT_EQ(text(call("jacobian", {offset, v3})),
            "mat3(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0)");
}

TEST_F(HostFunctions, PartialsMustBeOneNumberPerArgument) {
  const int called = callFunction(noise, {x, x});
  const std::vector<NodeId> pendingCalls = pendingFor(called);
  ASSERT_EQ(pendingCalls.size(), 1u);
  const NodeId pending = pendingCalls[0];
  EXPECT_FALSE(givePartials(pending, {x, v2}));
  EXPECT_EQ(builder.problem(), "noise: expected a single number as derivative 2, got a vec2.");
  EXPECT_FALSE(givePartials(pending, {x}));
  EXPECT_EQ(builder.problem(), "noise: expected 2 derivatives, one per argument, got 1.");
  EXPECT_EQ(pendingFor(called), pendingCalls) << "rejected partials are not stored";
  EXPECT_TRUE(givePartials(pending, {x, number(1)}));
  EXPECT_EQ(text(call("derivative", {called, x})), "x + 1.0");
}

TEST_F(HostFunctions, CannotBeEvaluatedByAProgram) {
  builder.output("gen", "y", callFunction(bump, {x}));
  const std::uint32_t first = 0;
  EXPECT_FALSE(program(builder.module(), {&first, 1}).program);
}

}  // namespace
}  // namespace warpjet
