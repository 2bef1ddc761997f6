// Forward-mode differentiation, graph to graph: a node and an input enter, the node of the partial
// derivative leaves. Derivatives are ordinary nodes, so a second derivative is the derivative of a
// derivative, and whatever they share with the values is shared by interning.
#pragma once

#include <utility>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

class Differentiator {
 public:
  explicit Differentiator(Graph& graph) : graph_(graph) {}

  // d root / d input, where `input` is a component of an input. Other inputs are held constant.
  NodeId derivative(NodeId root, NodeId input);

 private:
  // By node index, the derivative's node index plus one; 0 where it is not known yet.
  using Tangents = std::vector<std::uint32_t>;

  Tangents& tangentsBy(NodeId input);
  NodeId chainRule(NodeId id, const Tangents& tangents);

  Graph& graph_;
  std::vector<std::pair<NodeId, Tangents>> tangents_;  // by input; there are few
};

}  // namespace warpjet
