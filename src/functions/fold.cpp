#include "functions/fold.hpp"

#include "graph/flags.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

OpenFold openFold(Graph& graph, std::uint32_t steps, std::span<const NodeId> start) {
  const std::uint32_t loop = graph.addLoop(steps);
  OpenFold open{loop, {&graph, graph.stepOf(loop)}, {start.begin(), start.end()}, {}};
  for (std::size_t i = 0; i < start.size(); ++i) open.states.push_back(graph.addState(loop));
  return open;
}

namespace {

// Returns true for the states that the outcome of state `root` depends on.
Flags findNeeded(const Graph& graph, const OpenFold& open, std::span<const NodeId> next,
                 std::size_t root) {
  Flags isNeeded(next.size());
  isNeeded[root] = true;
  std::vector<std::size_t> pending{root};
  // Nodes older than the loop can't read its variables.
  const auto isOlder = [&](NodeId id) { return index(id) < index(open.step.id); };
  while (!pending.empty()) {
    const NodeId from = next[pending.back()];
    pending.pop_back();
    const std::vector<NodeId> nodes = reachable(graph, {&from, 1}, isOlder);
    for (const NodeId id : nodes) {
      if (!graph.isLocal(id) || graph.loopOf(id) != open.loop || graph.isStep(id)) continue;
      const std::size_t state = index(id) - index(open.states[0]);
      if (isNeeded[state]) continue;
      isNeeded[state] = true;
      pending.push_back(state);
    }
  }
  return isNeeded;
}

}  // namespace

std::vector<NodeId> closeFold(Graph& graph, const OpenFold& open, std::span<const NodeId> next) {
  if (graph.loop(open.loop).steps == 0) return open.start;
  std::vector<NodeId> outcomes;
  for (std::size_t i = 0; i < next.size(); ++i) {
    const Flags isNeeded = findNeeded(graph, open, next, i);
    std::vector<State> states;
    for (std::size_t k = 0; k < next.size(); ++k) {
      if (isNeeded[k]) states.push_back({open.states[k], open.start[k], next[k]});
    }
    outcomes.push_back(graph.outcome(graph.fold(open.loop, states), open.states[i]));
  }
  return outcomes;
}

namespace {

std::vector<NodeId> nodesOf(const Numbers& numbers) {
  std::vector<NodeId> nodes;
  for (const Expression x : numbers) nodes.push_back(x.id);
  return nodes;
}

Numbers numbersOf(Graph& graph, std::span<const NodeId> nodes) {
  Numbers numbers;
  for (const NodeId id : nodes) numbers.push_back({&graph, id});
  return numbers;
}

}  // namespace

OpenFold openFold(std::uint32_t steps, const Numbers& start) {
  return openFold(*start[0].graph, steps, nodesOf(start));
}

Numbers statesOf(const OpenFold& open) { return numbersOf(*open.step.graph, open.states); }

Numbers closeFold(const OpenFold& open, const Numbers& next) {
  Graph& graph = *open.step.graph;
  return numbersOf(graph, closeFold(graph, open, nodesOf(next)));
}

}  // namespace warpjet
