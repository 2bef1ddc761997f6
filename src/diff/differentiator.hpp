// Forward-mode differentiation, graph to graph: a node and an input enter, the node of the partial
// derivative leaves. Derivatives are ordinary nodes, so a second derivative is the derivative of a
// derivative, and whatever they share with the values is shared by interning.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

class Differentiator {
 public:
  explicit Differentiator(Graph& graph) : graph_(graph) {}

  // d root / d input, where `input` is a component of an input. Other inputs are held constant.
  // Calls of the host's functions on the way must have their partials.
  NodeId derivative(NodeId root, NodeId input);

 private:
  // By node index, its derivative.
  using Tangents = std::vector<NodeId>;
  static constexpr NodeId unknown{~std::uint32_t{0}};

  Tangents& tangentsBy(NodeId input);
  NodeId tangentOf(NodeId id, const Tangents& tangents);
  NodeId chainRule(NodeId id, const Tangents& tangents);
  NodeId chainRuleOfCall(NodeId call, const Tangents& tangents);

  Graph& graph_;
  std::vector<std::pair<NodeId, Tangents>> tangents_;  // by input; there are few
};

}  // namespace warpjet
