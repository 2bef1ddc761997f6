// Forward-mode differentiation, graph to graph: takes a node and an input, returns the node of the
// partial derivative. Derivatives are ordinary nodes, so a second derivative is the derivative of a
// derivative, and interning makes them share work with the values.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "diff/paged.hpp"
#include "graph/graph.hpp"

namespace warpjet {

// The nodes from `first` up to but excluding `end` were made to differentiate `origin`.
struct DerivedNodes {
  NodeId first, end, origin;
};

class Differentiator {
 public:
  explicit Differentiator(Graph& graph) : graph_(graph) {}

  // Returns d root / d input, where `input` is a component of an input. Treats other inputs as
  // constant. Calls of host functions that `root` depends on must have their partials. `root` may
  // read the variables of a loop only through folds of that loop.
  NodeId derivative(NodeId root, NodeId input);

  // From now on, new nodes are recorded in `log`.
  void logTo(std::vector<DerivedNodes>& log) { log_ = &log; }

  // Returns the bytes that the cache for later derivatives takes.
  std::size_t bytes() const { return bytes_; }

 private:
  // A node's derivative, as factor × base: `base` is the derivative of an earlier node m (or of the
  // node itself, with the factor 1), and `factor` is ∂node/∂m. If the node depends on all
  // components of an input only through m, `factor` is the same for each component, so the columns
  // of a Jacobian share it.
  struct Tangent {
    NodeId factor = noNode, base = noNode;
  };
  using Tangents = Paged<Tangent>;
  // The components of an input that a node depends on, one bit each.
  using Components = Paged<std::uint32_t>;

  // The max size of the cache, apart from the current derivative. If it is exceeded, the cache is
  // cleared and rebuilt on demand. Without this limit, derivatives of a million nodes with respect
  // to hundreds of inputs would fill the memory.
  static constexpr std::size_t maxBytes = std::size_t{1} << 27;

  // The state of differentiation with respect to one input component.
  struct Direction {
    NodeId input;
    NodeId zero, one;  // the constants 0 and 1
    Tangents& tangents;
    Components& components;
  };

  void clearIfTooLarge();
  void visit(NodeId id, const Direction& direction);
  std::uint32_t componentsOf(NodeId id, const Direction& direction) const;
  void findTangent(NodeId id, const Direction& direction);
  std::optional<NodeId> commonBase(NodeId id, const Direction& direction) const;
  bool canOverflow(NodeId id, const Tangents& tangents);
  // Selects the part of the operands' tangents that the chain rule is applied to.
  using Part = NodeId (Differentiator::*)(const Tangent&);
  NodeId chainRule(NodeId id, const Direction& direction, Part part);
  NodeId factorOf(const Tangent& tangent) { return tangent.factor; }
  NodeId fullTangent(const Tangent& tangent);

  // Returns true if the node belongs to a fold and was handled, or has to wait for the derivative
  // of its fold.
  [[gnu::noinline, gnu::cold]] bool visitFoldPart(NodeId id, const Direction& direction);
  bool isWaiting(NodeId id, const Tangents& tangents) const;
  bool findTangents(std::span<const State> states, const Direction& direction);
  void visitFold(NodeId id, const Direction& direction);
  NodeId tangentState(NodeId local, NodeId input);

  Graph& graph_;
  std::vector<DerivedNodes>* log_ = nullptr;
  // Maps the variable of a state, and an input, to the variable of the derivative.
  std::map<std::pair<NodeId, NodeId>, NodeId> tangentStates_;
  std::map<NodeId, Tangents> tangents_;
  std::map<std::uint32_t, Components> components_;  // by input
  std::size_t bytes_ = 0;                           // of tangents_ and components_
};

}  // namespace warpjet
