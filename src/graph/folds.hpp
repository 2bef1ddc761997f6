// Folds: a body that is applied a known number of times to its own result.
//
// The body is nodes of the same graph, which read the variables of a loop: the number of its step,
// and its states. A state says what its variable starts as and what each step makes of it; a fold
// is a loop with some states, and an outcome is what the variable of one of them is in the end.
// What a body computes without the variables of its loop is computed once, before it. Derivatives
// are more states of the same loop, so that value and derivatives share its steps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// Whoever walks a text, or unrolls, enters loops within loops.
inline constexpr std::uint32_t deepestLoops = 8;

// All nodes that some roots need, in loops: which of them it takes to run each, and an order of
// work that does all that a loop reads before it.
class Loops {
 public:
  static constexpr std::uint32_t outside = none;

  // `nodes` are all that the roots need, ascending.
  Loops(const Graph& graph, std::span<const NodeId> nodes);

  // Operands before users, and before a fold what any fold of its loop needs; without what only
  // folds read.
  const std::vector<NodeId>& order() const { return order_; }

  // The innermost loop whose variables a node reads.
  std::uint32_t loopOf(NodeId id) const { return setOf(id) == 0 ? outside : sets_[setOf(id)].loop; }
  // Whether it reads variables of that loop.
  bool reads(NodeId id, std::uint32_t loop) const;
  // The loop that a loop stands in.
  std::uint32_t around(std::uint32_t loop) const { return loopOf(folds_[loop][0]); }

  // Of a loop that is needed, all of its states that are.
  const std::vector<State>& statesOf(std::uint32_t loop) const { return states_[loop]; }
  // The number of its step, if that is.
  std::optional<NodeId> stepOf(std::uint32_t loop) const { return steps_[loop]; }

 private:
  // Loops whose variables are read: the innermost, which has the highest number, and the others.
  struct Set {
    std::uint32_t loop, rest;
  };

  enum class Progress : std::uint8_t { None, Entered, Done };

  void gather(std::span<const NodeId> nodes);
  void visit(NodeId root);
  std::vector<NodeId> readsOf(NodeId id) const;
  void leave(NodeId id);
  std::uint32_t setOf(NodeId id) const { return setOf_[index(id)]; }
  std::uint32_t with(std::uint32_t loop, std::uint32_t rest);
  std::uint32_t both(std::uint32_t a, std::uint32_t b);
  std::uint32_t without(std::uint32_t set, std::uint32_t loop);

  const Graph& graph_;
  std::vector<std::vector<NodeId>> folds_;    // by loop
  std::vector<std::vector<State>> states_;    // by loop
  std::vector<std::optional<NodeId>> steps_;  // by loop
  std::vector<Progress> progress_;            // by node
  std::vector<std::uint32_t> setOf_;          // by node
  std::vector<Set> sets_{{outside, 0}};       // the first one is empty
  std::vector<NodeId> order_;
};

}  // namespace warpjet
