// The derivative of a fold is a larger fold: of its states and of their derivatives.
#include "diff/differentiator.hpp"
#include "graph/flags.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

// Returns true for nodes that read a state whose derivative is unknown until its fold is reached.
bool Differentiator::isWaiting(NodeId id, const Tangents& tangents) const {
  if (graph_.isLocal(id)) return !graph_.isStep(id);
  if (graph_.isFold(id)) return false;
  if (graph_.isStateOrList(id)) return true;
  for (int i = 0; i < graph_.arity(id); ++i) {
    if (tangents[graph_.operand(id, i)].factor == noNode) return true;
  }
  return false;
}

NodeId Differentiator::tangentState(NodeId local, NodeId input) {
  const auto [known, isNew] = tangentStates_.try_emplace({local, input}, noNode);
  if (isNew) known->second = graph_.addState(graph_.loopOf(local));
  return known->second;
}

// Finds the states that vary: their initial value has a nonzero derivative, or they read a state
// that varies. Repeats passes over the body until a pass finds no more such states. Returns false
// if the body reads a state of an enclosing loop, whose fold comes later.
bool Differentiator::findTangents(std::span<const State> states, const Direction& direction) {
  const auto& [input, zero, one, tangents, components] = direction;
  std::vector<NodeId> nexts;
  Flags varies(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (tangents[states[i].start].factor == noNode) return false;
    nexts.push_back(states[i].next);
    varies[i] = fullTangent(tangents[states[i].start]) != zero;
  }
  const auto isKnown = [&](NodeId id) { return direction.tangents[id].factor != noNode; };
  const std::vector<NodeId> body = reachable(graph_, nexts, isKnown);
  for (bool isFinal = false; !isFinal;) {
    isFinal = true;
    for (const NodeId id : body) tangents.set(id) = {};
    for (std::size_t i = 0; i < states.size(); ++i) {
      const NodeId local = states[i].local;
      tangents.set(local) = {varies[i] ? tangentState(local, input) : zero, one};
    }
    for (const NodeId id : body) {
      if (!isKnown(id)) visit(id, direction);
    }
    for (const NodeId next : nexts) {
      if (isKnown(next)) continue;
      for (const NodeId id : body) tangents.set(id) = {};
      for (const State& state : states) tangents.set(state.local) = {};
      return false;
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (varies[i] || fullTangent(tangents[states[i].next]) == zero) continue;
      varies[i] = true;
      isFinal = false;
    }
  }
  return true;
}

bool Differentiator::visitFoldPart(NodeId id, const Direction& direction) {
  Tangents& tangents = direction.tangents;
  if (isWaiting(id, tangents)) return true;
  if (graph_.isFold(id)) {
    visitFold(id, direction);
    return true;
  }
  if (!graph_.isOutcome(id)) return false;
  // The derivative of an outcome is an outcome of the extended fold: that of the variable's
  // derivative.
  const NodeId fold = tangents[graph_.operand(id, 0)].factor;
  const NodeId local = tangents[graph_.operand(id, 1)].factor;
  const NodeId zero = direction.zero;
  const bool varies = local != zero && graph_.isFold(fold);
  tangents.set(id) = {varies ? graph_.outcome(fold, local) : zero, direction.one};
  return true;
}

void Differentiator::visitFold(NodeId id, const Direction& direction) {
  Tangents& tangents = direction.tangents;
  const NodeId zero = direction.zero;
  std::vector<State> states = graph_.states(id), unknown;
  for (const State& state : states) {
    if (tangents[state.local].factor == noNode) unknown.push_back(state);
  }
  if (!unknown.empty() && !findTangents(unknown, direction)) return;
  for (std::size_t i = 0, count = states.size(); i < count; ++i) {
    const auto [local, start, next] = states[i];
    const NodeId tangentLocal = tangents[local].factor;
    if (tangentLocal != zero)
      states.push_back({tangentLocal, fullTangent(tangents[start]), fullTangent(tangents[next])});
  }
  // The extended fold is stored in place of a tangent; only outcomes read it.
  tangents.set(id) = {graph_.fold(graph_.loopOf(id), states), direction.one};
}

}  // namespace warpjet
