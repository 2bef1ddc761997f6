#include "emit/early_end.hpp"

#include <algorithm>
#include <unordered_map>

namespace warpjet {

namespace {

// Limits recursion; deeper conditions count as unknown.
constexpr int maxDepth = 24;

// Simplifies the values of a step under the assumption that the flag is more than 0.5.
class Assumption {
 public:
  Assumption(const Graph& graph, NodeId flag) : graph_(graph), flag_(flag) {}

  // Returns the value that an `ifElse` has under the assumption, as far as its conditions are
  // known.
  NodeId chosen(NodeId id, int depth = maxDepth) {
    if (depth == 0 || !graph_.is(id, ops::find("ifElse"))) return id;
    const auto known = chosen_.find(id);
    return known != chosen_.end() ? known->second : chosen_[id] = follow(id, depth);
  }

 private:
  NodeId follow(NodeId id, int depth) {
    const auto condition = truth(graph_.operand(id, 0), depth - 1);
    const NodeId yes = graph_.operand(id, 1), no = graph_.operand(id, 2);
    if (condition) return chosen(*condition ? yes : no, depth - 1);
    const NodeId value = chosen(yes, depth - 1);
    return value == chosen(no, depth - 1) ? value : id;
  }

  std::optional<bool> truth(NodeId id, int depth) const {
    if (depth == 0) return {};
    if (isFlag(id)) return true;
    if (graph_.is(id, ops::find("not"))) {
      const auto negated = truth(graph_.operand(id, 0), depth - 1);
      return negated ? std::optional(!*negated) : std::nullopt;
    }
    const bool isOr = graph_.is(id, ops::find("or"));
    if (!isOr && !graph_.is(id, ops::find("and"))) return {};
    const auto a = truth(graph_.operand(id, 0), depth - 1);
    const auto b = truth(graph_.operand(id, 1), depth - 1);
    // A single operand decides the result: a true one for `or`, a false one for `and`.
    if (a == isOr || b == isOr) return isOr;
    return a && b ? std::optional(!isOr) : std::nullopt;
  }

  // Returns true for the condition that the flag is more than 0.5.
  bool isFlag(NodeId id) const {
    return graph_.is(id, ops::find("gt")) && graph_.operand(id, 0) == flag_ &&
           graph_.isConstant(graph_.operand(id, 1), 0.5);
  }

  const Graph& graph_;
  NodeId flag_;
  // Caches the result for each `ifElse`, since several nodes may read the same one.
  std::unordered_map<NodeId, NodeId> chosen_;
};

// Returns true if `flag` ends the loop: once it is more than 0.5, it remains so, and all other
// states keep their values.
bool ends(const Graph& graph, std::span<const State> states, const State& flag) {
  Assumption hasEnded(graph, flag.local);
  const NodeId next = hasEnded.chosen(flag.next);
  if (next != flag.local && !graph.isConstant(next, 1)) return false;
  return std::all_of(states.begin(), states.end(), [&](const State& state) {
    return state.local == flag.local || hasEnded.chosen(state.next) == state.local;
  });
}

}  // namespace

std::optional<NodeId> earlyEnd(const Graph& graph, std::span<const State> states) {
  for (const State& state : states) {
    if (graph.endsLoop(state.local)) return state.local;
  }
  for (const State& state : states) {
    if (graph.is(state.next, ops::find("ifElse")) && ends(graph, states, state)) return state.local;
  }
  return {};
}

}  // namespace warpjet
