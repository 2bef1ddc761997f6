// Folds: a body that is applied to its own result a fixed number of times, or until its first state
// says that it has ended.
//
// The body consists of nodes of the same graph that read the variables of a loop: its step number
// and its states. A state defines the initial value of its variable and the new value in each step;
// a fold is a loop with some of its states, and an outcome is the final value of one state's
// variable. The part of a body that doesn't read the loop's variables is computed once, before the
// loop. Derivatives are additional states of the same loop, so value and derivatives share its
// steps.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// Limits recursion: both the emitter and the unroller recurse once per nested loop.
inline constexpr std::uint32_t maxLoopDepth = 8;

// Groups the nodes that some roots need by loop: which nodes each loop has to compute per step, and
// an evaluation order in which everything that a loop reads is computed before it.
class Loops {
 public:
  static constexpr std::uint32_t outside = none;

  // `nodes` are all nodes that the roots need, in ascending order.
  Loops(const Graph& graph, std::span<const NodeId> nodes);

  // Operands precede their users, and every fold of a loop is preceded by all nodes that any fold
  // of this loop needs. Nodes that only folds read (states and lists of them) are left out.
  const std::vector<NodeId>& order() const { return order_; }

  // Returns the innermost loop whose variables the node reads.
  std::uint32_t loopOf(NodeId id) const { return setOf(id) == 0 ? outside : sets_[setOf(id)].loop; }
  // Returns true if the node reads variables of that loop.
  bool reads(NodeId id, std::uint32_t loop) const;
  // Returns the loop that directly encloses a loop.
  std::uint32_t parentOf(std::uint32_t loop) const { return loopOf(folds_[loop][0]); }

  // Returns all needed states of a needed loop.
  const std::vector<State>& statesOf(std::uint32_t loop) const { return states_[loop]; }
  // Returns the node of the loop's step number, if it is needed.
  std::optional<NodeId> stepOf(std::uint32_t loop) const { return steps_[loop]; }

 private:
  // The set of loops whose variables are read: the innermost loop, which has the highest number,
  // and the set of the others.
  struct Set {
    std::uint32_t loop, rest;
  };

  enum class Progress : std::uint8_t { None, Entered, Done };

  void gather(std::span<const NodeId> nodes);
  void visit(NodeId root);
  std::vector<NodeId> readsOf(NodeId id) const;
  void leave(NodeId id);
  std::uint32_t setOf(NodeId id) const { return setOf_[index(id)]; }
  std::uint32_t makeSet(std::uint32_t loop, std::uint32_t rest);
  std::uint32_t unite(std::uint32_t a, std::uint32_t b);
  std::uint32_t removeLoop(std::uint32_t set, std::uint32_t loop);

  const Graph& graph_;
  std::vector<std::vector<NodeId>> folds_;    // by loop
  std::vector<std::vector<State>> states_;    // by loop
  std::vector<std::optional<NodeId>> steps_;  // by loop
  std::vector<Progress> progress_;            // by node
  std::vector<std::uint32_t> setOf_;          // by node
  std::vector<Set> sets_{{outside, 0}};       // set 0 is empty
  std::vector<NodeId> order_;
};

}  // namespace warpjet
