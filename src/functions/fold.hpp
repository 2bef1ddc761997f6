// How a fold is written: its body is built from the variables of a loop that is open, and closed
// when it is known what each of them becomes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functions/definition.hpp"

namespace warpjet {

// Whole numbers up to here are exact in an integer of any precision that a shader counts with.
inline constexpr std::uint32_t mostSteps = 10'000;

// A loop whose body is being made: the number of its step, from 0 on, and a state for each number
// that it starts with.
struct OpenFold {
  std::uint32_t loop = none;
  Expression step{};
  std::vector<NodeId> start, states;
};

OpenFold openFold(Graph& graph, std::uint32_t steps, std::span<const NodeId> start);

// What the states are after all steps, if each step makes `next` of them. Of each outcome only the
// states that it needs are in its fold.
std::vector<NodeId> closeFold(Graph& graph, const OpenFold& open, std::span<const NodeId> next);

// With numbers in the place of nodes, for what follows.
OpenFold openFold(std::uint32_t steps, const Numbers& start);
Numbers statesOf(const OpenFold& open);
Numbers closeFold(const OpenFold& open, const Numbers& next);

// A whole fold: `body(states, step)` gives what each step makes of them.
template <class Body>
Numbers fold(std::uint32_t steps, const Numbers& start, Body body) {
  const OpenFold open = openFold(steps, start);
  return closeFold(open, body(statesOf(open), open.step));
}

}  // namespace warpjet
