// Forward-mode differentiation, graph to graph: a node and an input enter, the node of the partial
// derivative leaves. Derivatives are ordinary nodes, so a second derivative is the derivative of a
// derivative, and whatever they share with the values is shared by interning.
#pragma once

#include <cstdint>
#include <optional>
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
  // By node index, its derivative as a product: the base is the derivative of an earlier node, the
  // factor what the chain rule has made since. Where all components of an input have come by that
  // node, the factor is the same for each of them, so that the columns of a Jacobian share it.
  struct Tangents {
    NodeId input;
    std::vector<NodeId> factors = {}, bases = {};
  };
  // By node index, on which components of an input it depends, a bit each.
  struct Components {
    std::uint32_t input;
    std::vector<std::uint32_t> bits = {};
  };
  static constexpr NodeId unknown{~std::uint32_t{0}};

  Tangents& tangentsBy(NodeId input);
  const Components& componentsOf(std::uint32_t input);
  void findTangent(NodeId id, Tangents& tangents, const Components& components);
  std::optional<NodeId> commonBase(NodeId id, const Tangents& tangents,
                                   const Components& components) const;
  bool canOverflow(NodeId id, const Tangents& tangents);
  template <class TangentOf>
  NodeId chainRule(NodeId id, TangentOf tangent);
  NodeId whole(NodeId id, const Tangents& tangents);

  Graph& graph_;
  // There are few inputs.
  std::vector<Tangents> tangents_;
  std::vector<Components> components_;
};

}  // namespace warpjet
