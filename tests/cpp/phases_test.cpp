// Phases: the arguments of waves and noises, at which a mesh is sampled finely enough.
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

}  // namespace
}  // namespace warpjet
