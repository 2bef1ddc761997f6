// Lowering replaces the operations that a language lacks, and no others.
#include "emit/lower.hpp"

#include <gtest/gtest.h>

#include <random>

#include "diff/differentiator.hpp"
#include "ops/rows.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

using ops::Language;

constexpr std::array languages{Language::Glsl300, Language::Glsl100, Language::Wgsl};

class LowerTest : public testing::Test {
 protected:
  Graph graph;
  Value v = variable(graph, "v", vectorOf(3));

  Expression lowerRoot(Expression root, Language language) {
    Comments none;
    return {&graph, lower(graph, {&root.id, 1}, language, none)[0]};
  }

  Expression apply(std::string_view row) {
    return {&graph, graph.apply(rowNamed(row), {v[0].id, v[1].id, v[2].id})};
  }

  void expectWritable(NodeId root, Language language, std::string_view what) {
    for (const NodeId id : reachable(graph, {&root, 1})) {
      if (!graph.isOperation(id)) continue;
      const Op op = graph.node(id).op;
      EXPECT_NE(ops::spelling(op, language).text, "")
          << what << " needs " << ops::declaration(op).name;
    }
  }

  // Returns a point in the domain of a row: above 1 for acosh, below 1 for asin and the like.
  Inputs point(std::mt19937& random, ops::Domain domain) {
    Inputs inputs;
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = domain[i];
      inputs[v[i].id] = std::uniform_real_distribution(low, high)(random);
    }
    return inputs;
  }
};

constexpr auto domains =
    std::apply([](const auto&... row) { return std::array{row.domain...}; }, ops::table);

TEST_F(LowerTest, EveryLoweredRowHasTheSameValueAndIsWritable) {
  std::mt19937 random(1);
  for (const ops::Declaration& info : ops::declarations) {
    const Expression root = apply(info.name);
    for (const Language language : languages) {
      // Languages without bitwise operations report that; see tests/glsl-source/glsl.test.js.
      if (findUnsupported(graph, {&root.id, 1}, language)) continue;
      const Expression low = lowerRoot(root, language);
      expectWritable(low.id, language, info.name);
      for (int i = 0; i < 50; ++i) {
        const Inputs operands = point(random, domains[index(rowNamed(info.name))]);
        // Integer division by zero is undefined in all languages.
        if (info.name == "intMod" && std::abs(operands.at(v[1].id)) < 1) continue;
        const double expected = evaluateNode(graph, root.id, operands);
        // The bits of some integers are those of NaN.
        if (info.name == "intBitsToFloat" && std::isnan(expected)) continue;
        EXPECT_NEAR(evaluateNode(graph, low.id, operands), expected, 1e-12) << info.name;
      }
    }
  }
}

TEST_F(LowerTest, LoweringPreservesTheValuesOfDerivatives) {
  Differentiator differentiator(graph);
  std::mt19937 random(2);
  for (const ops::Declaration& info : ops::declarations) {
    const Expression root = apply(info.name);
    const Expression slope{&graph, differentiator.derivative(root.id, v[0].id)};
    const Expression curvature{&graph, differentiator.derivative(slope.id, v[0].id)};
    for (const Language language : languages) {
      for (const Expression derivative : {slope, curvature}) {
        const Expression low = lowerRoot(derivative, language);
        expectWritable(low.id, language, info.name);
        const Inputs at = point(random, domains[index(rowNamed(info.name))]);
        const double expected = evaluateNode(graph, derivative.id, at);
        EXPECT_NEAR(evaluateNode(graph, low.id, at), expected,
                    1e-12 * std::max(1.0, std::abs(expected)))
            << info.name;
      }
    }
  }
}

TEST_F(LowerTest, OperationsThatTheLanguageHasAreUnchanged) {
  const Expression f = sin(v[0]) * floor(v[1]) + mod(v[0], v[2]);
  EXPECT_EQ(lowerRoot(f, Language::Glsl300).id, f.id);
  EXPECT_EQ(lowerRoot(f, Language::Glsl100).id, f.id);
  EXPECT_NE(lowerRoot(f, Language::Wgsl).id, f.id) << "WGSL lacks mod";
}

TEST_F(LowerTest, LowersNestedMissingOperations) {
  const Expression inner = apply("trunc");
  const Expression outer{&graph, graph.apply(rowNamed("tanh"), {(inner * v[1]).id})};
  const Expression low = lowerRoot(sin(outer) + v[2], Language::Glsl100);
  expectWritable(low.id, Language::Glsl100, "sin(tanh(trunc(x) * y)) + z");
  const Inputs at{{v[0].id, -2.75}, {v[1].id, 0.25}, {v[2].id, 3}};
  EXPECT_DOUBLE_EQ(evaluateNode(graph, low.id, at), std::sin(std::tanh(-0.5)) + 3);
}

TEST_F(LowerTest, LowersTheArgumentsOfCalls) {
  const std::uint32_t noise = graph.addFunction({"noise", 2});
  const NodeId arguments[] = {apply("trunc").id, v[1].id};
  const Expression f = sin(Expression{&graph, graph.call(noise, arguments)});
  const Expression low = lowerRoot(f, Language::Glsl100);
  expectWritable(low.id, Language::Glsl100, "sin(noise(trunc(x), y))");
  EXPECT_EQ(body(low, glsl100), "sin(noise(sign(v.x) * floor(abs(v.x)), v.y))");
  EXPECT_EQ(lowerRoot(f, Language::Glsl300).id, f.id) << "it has nothing to lower";
}

TEST_F(LowerTest, ACallWithNothingToLowerIsUnchanged) {
  const std::uint32_t noise = graph.addFunction({"noise", 1});
  const Expression call{&graph, graph.call(noise, std::vector{v[0].id})};
  EXPECT_EQ(lowerRoot(call, Language::Glsl100).id, call.id);
}

TEST_F(LowerTest, AcceptsLeavesAndRepeatedRoots) {
  const NodeId seven = graph.constant(7), truncated = apply("trunc").id;
  const std::vector<NodeId> roots{v[0].id, seven, truncated, truncated, v[0].id};
  Comments none;
  const std::vector<NodeId> low = lower(graph, roots, Language::Glsl100, none);
  ASSERT_EQ(low.size(), 5u);
  EXPECT_EQ(low[0], v[0].id);
  EXPECT_EQ(low[1], seven);
  EXPECT_EQ(low[2], low[3]);
  EXPECT_EQ(low[4], v[0].id);
}

TEST_F(LowerTest, NewNodesInheritTheCommentOfTheReplacedNode) {
  const auto end = [&] { return NodeId{static_cast<std::uint32_t>(graph.size())}; };
  const NodeId first = end();
  const Expression truncated = apply("trunc");
  Comments comments{{"the cut"}, {{first, end(), 0}}};
  const NodeId root = truncated.id;
  const NodeId low = lower(graph, {&root, 1}, Language::Glsl100, comments)[0];
  ASSERT_NE(low, root);
  ASSERT_NE(comments.find(low), nullptr);
  EXPECT_EQ(comments.texts[comments.find(low)->text], "the cut");
}

TEST_F(LowerTest, LowersALongChainWithoutRecursion) {
  Expression f = v[0];
  for (int i = 0; i < 100'000; ++i) f = {&graph, graph.apply(rowNamed("tanh"), {f.id})};
  EXPECT_LT(index(lowerRoot(f, Language::Glsl100).id), 1'200'000u);
}

}  // namespace
}  // namespace warpjet
