#include "graph/folds.hpp"

#include <algorithm>

#include "graph/flags.hpp"

namespace warpjet {

std::uint32_t Graph::addLoop(std::uint32_t steps) {
  loops_.push_back({steps});
  return static_cast<std::uint32_t>(loops_.size() - 1);
}

NodeId Graph::addState(std::uint32_t loop) {
  return intern(Node{{loop, loops_[loop].locals++}, localOp});
}

bool Graph::endsLoop(NodeId local) const {
  return !loops_[loopOf(local)].isCounted() && node(local).operands[1] == 1;
}

NodeId Graph::fold(std::uint32_t loop, std::span<const State> states) {
  std::vector<NodeId> items;
  for (const auto& [local, start, next] : states) {
    const NodeId from = convert(start, ops::Type::Float), to = convert(next, ops::Type::Float);
    items.push_back(intern(Node{{index(local), index(from), index(to)}, stateOp}));
  }
  return intern(Node{{index(makeList(items)), loop}, foldOp});
}

std::vector<State> Graph::states(NodeId fold) const {
  std::vector<State> all;
  for (const NodeId id : list(operand(fold, 0)))
    all.push_back({operand(id, 0), operand(id, 1), operand(id, 2)});
  return all;
}

Loops::Loops(const Graph& graph, std::span<const NodeId> nodes)
    : graph_(graph),
      folds_(graph.loopCount()),
      states_(graph.loopCount()),
      steps_(graph.loopCount()),
      progress_(graph.size()),
      setOf_(graph.size()) {
  gather(nodes);
  order_.reserve(nodes.size());
  for (const NodeId id : nodes) {
    if (!graph_.isStateOrList(id)) visit(id);
  }
}

void Loops::gather(std::span<const NodeId> nodes) {
  Flags isKnown(graph_.size());
  for (const NodeId id : nodes) {
    if (graph_.isStep(id)) steps_[graph_.loopOf(id)] = id;
    if (!graph_.isFold(id)) continue;
    const std::uint32_t loop = graph_.loopOf(id);
    folds_[loop].push_back(id);
    for (const State& state : graph_.states(id)) {
      if (isKnown[index(state.local)]) continue;
      isKnown[index(state.local)] = true;
      states_[loop].push_back(state);
    }
  }
}

// Returns the nodes that a node reads. All folds of one loop are treated as a single fold with the
// union of their states.
std::vector<NodeId> Loops::readsOf(NodeId id) const {
  std::vector<NodeId> reads;
  if (graph_.isFold(id)) {
    for (const State& state : states_[graph_.loopOf(id)]) {
      reads.push_back(state.start);
      reads.push_back(state.next);
    }
  } else {
    for (int i = 0; i < graph_.arity(id); ++i) reads.push_back(graph_.operand(id, i));
  }
  return reads;
}

void Loops::visit(NodeId root) {
  std::vector<NodeId> pending{root};
  while (!pending.empty()) {
    const NodeId id = pending.back();
    Progress& progress = progress_[index(id)];
    if (progress == Progress::None) {
      progress = Progress::Entered;
      for (const NodeId read : readsOf(id)) {
        if (progress_[index(read)] == Progress::None) pending.push_back(read);
      }
    } else {
      pending.pop_back();
      if (progress == Progress::Entered) leave(id);
      progress = Progress::Done;
    }
  }
}

void Loops::leave(NodeId id) {
  order_.push_back(id);
  std::uint32_t& set = setOf_[index(id)];
  if (graph_.isLocal(id)) {
    set = makeSet(graph_.loopOf(id), 0);
  } else if (graph_.isOutcome(id)) {
    set = setOf(graph_.operand(id, 0));
  } else {
    for (const NodeId read : readsOf(id)) set = unite(set, setOf(read));
    if (graph_.isFold(id)) set = removeLoop(set, graph_.loopOf(id));
  }
}

bool Loops::reads(NodeId id, std::uint32_t loop) const {
  std::uint32_t set = setOf(id);
  while (set != 0 && sets_[set].loop != loop) set = sets_[set].rest;
  return set != 0;
}

std::uint32_t Loops::makeSet(std::uint32_t loop, std::uint32_t rest) {
  for (std::uint32_t i = 1; i < sets_.size(); ++i) {
    if (sets_[i].loop == loop && sets_[i].rest == rest) return i;
  }
  sets_.push_back({loop, rest});
  return static_cast<std::uint32_t>(sets_.size() - 1);
}

std::uint32_t Loops::unite(std::uint32_t a, std::uint32_t b) {
  if (a == b || b == 0) return a;
  if (a == 0) return b;
  if (sets_[a].loop < sets_[b].loop) std::swap(a, b);
  const auto [loop, rest] = sets_[a];
  const std::uint32_t unitedRest = unite(rest, sets_[b].loop == loop ? sets_[b].rest : b);
  return unitedRest == rest ? a : makeSet(loop, unitedRest);
}

std::uint32_t Loops::removeLoop(std::uint32_t set, std::uint32_t loop) {
  if (set == 0) return 0;
  const auto [first, rest] = sets_[set];
  return first == loop ? rest : makeSet(first, removeLoop(rest, loop));
}

}  // namespace warpjet
