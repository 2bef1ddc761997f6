// Constructs folds: open a loop, build its body from the loop's variables, then close it with the
// new value of each variable.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functions/definition.hpp"

namespace warpjet {

// Integers up to this limit are exact in every precision that a shader may use for the counter.
inline constexpr std::uint32_t maxSteps = 10'000;

// A loop whose body is being built: its step number, counted from 0, and a state for each initial
// value.
struct OpenFold {
  std::uint32_t loop = none;
  Expression step{};
  std::vector<NodeId> start, states;
};

OpenFold openFold(Graph& graph, std::uint32_t steps, std::span<const NodeId> start);

// Returns the values of the states after the last step, given the value of each state after one
// step. The fold of each outcome only includes the states that it depends on.
std::vector<NodeId> closeFold(Graph& graph, const OpenFold& open, std::span<const NodeId> next);

// Variants that take Numbers in place of nodes.
OpenFold openFold(std::uint32_t steps, const Numbers& start);
Numbers statesOf(const OpenFold& open);
Numbers closeFold(const OpenFold& open, const Numbers& next);

// Returns a complete fold: `body(states, step)` returns the states after a step.
template <class Body>
Numbers fold(std::uint32_t steps, const Numbers& start, Body body) {
  const OpenFold open = openFold(steps, start);
  return closeFold(open, body(statesOf(open), open.step));
}

}  // namespace warpjet
