// The derivative of a fold is a fold of more: of its states and of their derivatives.
#include "diff/differentiator.hpp"
#include "graph/flags.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

// What reads a state whose derivative is not known before its fold is reached.
bool Differentiator::isWaiting(NodeId id, const Tangents& tangents) const {
  if (graph_.isLocal(id)) return !graph_.isStep(id);
  if (graph_.isFold(id)) return false;
  if (graph_.isOfStates(id)) return true;
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

// Those move that start with a derivative, or come to have one by a state that does: of these there
// are the more, the more often the body is derived, until there are no more. False if the body
// reads a state of a loop around it, whose fold is yet to come.
bool Differentiator::findTangents(std::span<const State> states, const Direction& direction) {
  const auto& [input, zero, one, tangents, components] = direction;
  std::vector<NodeId> nexts;
  Flags moves(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (tangents[states[i].start].factor == noNode) return false;
    nexts.push_back(states[i].next);
    moves[i] = whole(tangents[states[i].start]) != zero;
  }
  const auto isKnown = [&](NodeId id) { return direction.tangents[id].factor != noNode; };
  const std::vector<NodeId> body = reachable(graph_, nexts, isKnown);
  for (bool isFinal = false; !isFinal;) {
    isFinal = true;
    for (const NodeId id : body) tangents.set(id) = {};
    for (std::size_t i = 0; i < states.size(); ++i) {
      const NodeId local = states[i].local;
      tangents.set(local) = {moves[i] ? tangentState(local, input) : zero, one};
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
      if (moves[i] || whole(tangents[states[i].next]) == zero) continue;
      moves[i] = true;
      isFinal = false;
    }
  }
  return true;
}

bool Differentiator::visitOfFold(NodeId id, const Direction& direction) {
  Tangents& tangents = direction.tangents;
  if (isWaiting(id, tangents)) return true;
  if (graph_.isFold(id)) {
    visitFold(id, direction);
    return true;
  }
  if (!graph_.isOutcome(id)) return false;
  // The derivative of the same variable, of the fold that has it too.
  const NodeId fold = tangents[graph_.operand(id, 0)].factor;
  const NodeId local = tangents[graph_.operand(id, 1)].factor;
  const NodeId zero = direction.zero;
  const bool moves = local != zero && graph_.isFold(fold);
  tangents.set(id) = {moves ? graph_.outcome(fold, local) : zero, direction.one};
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
    const NodeId moving = tangents[local].factor;
    if (moving != zero) states.push_back({moving, whole(tangents[start]), whole(tangents[next])});
  }
  // In the place of a tangent; only outcomes read it.
  tangents.set(id) = {graph_.fold(graph_.loopOf(id), states), direction.one};
}

}  // namespace warpjet
