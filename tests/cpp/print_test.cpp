// Printed nodes and modules, compared with text written by hand.
#include "graph/print.hpp"

#include <gtest/gtest.h>

#include "graph/folds.hpp"
#include "module/print.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

std::string printRoot(const Graph& graph, NodeId root) { return print(graph, {&root, 1}); }

TEST(Print, PrintsOneLinePerOperation) {
  Graph graph;
  const Value p = vector3(graph, "p");
  const Expression time = scalar(graph, "time");
  const Expression root = sin(p[0] * 2.0 + time) + p[1];
  EXPECT_EQ(printRoot(graph, root.id),
            "n5 = mult(p.x, 2)\n"
            "n6 = add(n5, time)\n"
            "n7 = sin(n6)\n"
            "n8 = add(n7, p.y)\n");
}

TEST(Print, OmitsNodesThatNoRootNeeds) {
  Graph graph;
  const Expression x = scalar(graph, "x"), unused = cos(x);
  EXPECT_EQ(printRoot(graph, sin(x).id), "n2 = sin(x)\n");
  EXPECT_EQ(printRoot(graph, x.id), "");
  EXPECT_EQ(printRoot(graph, unused.id), "n1 = cos(x)\n");
}

TEST(Print, PrintsAllDigitsOfAConstant) {
  Graph graph;
  const Expression x = scalar(graph, "x");
  EXPECT_EQ(printRoot(graph, (x * 0.1).id), "n2 = mult(x, 0.1)\n");
  EXPECT_EQ(printRoot(graph, (x * (1.0 / 3)).id), "n4 = mult(x, 0.33333333333333331)\n");
}

TEST(Print, PrintsALoopInOneLine) {
  Graph graph;
  const Expression x = scalar(graph, "x");
  const std::uint32_t loop = graph.addLoop(5);
  const Expression state{&graph, graph.addState(loop)}, step{&graph, graph.stepOf(loop)};
  const NodeId fold = graph.fold(loop, std::array{State{state.id, x.id, (state * step).id}});
  EXPECT_EQ(printRoot(graph, graph.outcome(fold, state.id)),
            "n3 = mult(state0.1, step0)\n"
            "n5 = 5 times; state0.1 from x to n3\n"
            "n6 = state0.1 after n5\n");
}

TEST(Print, PrintsTheNamesOfAModulesResults) {
  Module module;
  const Expression x = scalar(module.graph, "x"), y = sin(x);
  module.outputs = {result("y", Value(y)), {"z", vectorOf(2), {x.id, module.graph.constant(3)}}};
  EXPECT_EQ(print(module),
            "n1 = sin(x)\n"
            "y: n1\n"
            "z: x, 3\n");
}

}  // namespace
}  // namespace warpjet
