// Forward-mode differentiation, graph to graph: a node and an input enter, the node of the partial
// derivative leaves. Derivatives are ordinary nodes, so a second derivative is the derivative of a
// derivative, and whatever they share with the values is shared by interning.
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

// The nodes from `first` to before `end` were made for the derivative of one.
struct Derived {
  NodeId first, end, of;
};

class Differentiator {
 public:
  explicit Differentiator(Graph& graph) : graph_(graph) {}

  // d root / d input, where `input` is a component of an input. Other inputs are held constant.
  // Calls of the host's functions on the way must have their partials, and `root` must read no
  // variable of a loop outside of its fold.
  NodeId derivative(NodeId root, NodeId input);

  // From now on it tells what it makes.
  void logTo(std::vector<Derived>& log) { log_ = &log; }

  // What it remembers for later derivatives.
  std::size_t bytes() const { return bytes_; }

 private:
  // A node's derivative as a product: the base is the derivative of an earlier node, the factor
  // what the chain rule has made since. Where all components of an input have come by that node,
  // the factor is the same for each of them, so that the columns of a Jacobian share it.
  struct Tangent {
    NodeId factor = noNode, base = noNode;
  };
  using Tangents = Paged<Tangent>;
  // On which components of an input a node depends, a bit each.
  using Components = Paged<std::uint32_t>;

  // What is remembered, at most, but for one derivative; then all is forgotten, and found again
  // where it is needed. Hundreds of parameters of a million nodes would take all memory.
  static constexpr std::size_t mostBytes = std::size_t{1} << 27;

  // What is known of one direction.
  struct Direction {
    NodeId input;
    NodeId zero, one;  // the constants
    Tangents& tangents;
    Components& components;
  };

  void forgetIfTooMuch();
  void visit(NodeId id, const Direction& direction);
  std::uint32_t componentsOf(NodeId id, const Direction& direction) const;
  void findTangent(NodeId id, const Direction& direction);
  std::optional<NodeId> commonBase(NodeId id, const Direction& direction) const;
  bool canOverflow(NodeId id, const Tangents& tangents);
  // What of the operands' tangents the chain rule is of.
  using Part = NodeId (Differentiator::*)(const Tangent&);
  NodeId chainRule(NodeId id, const Direction& direction, Part part);
  NodeId factorOf(const Tangent& tangent) { return tangent.factor; }
  NodeId whole(const Tangent& tangent);

  // Whether it was, or has to wait for, the derivative of a fold.
  [[gnu::noinline, gnu::cold]] bool visitOfFold(NodeId id, const Direction& direction);
  bool isWaiting(NodeId id, const Tangents& tangents) const;
  bool findTangents(std::span<const State> states, const Direction& direction);
  void visitFold(NodeId id, const Direction& direction);
  NodeId tangentState(NodeId local, NodeId input);

  Graph& graph_;
  std::vector<Derived>* log_ = nullptr;
  // By the variable of a state and an input, the variable of its derivative.
  std::map<std::pair<NodeId, NodeId>, NodeId> tangentStates_;
  std::map<NodeId, Tangents> tangents_;
  std::map<std::uint32_t, Components> components_;  // by input
  std::size_t bytes_ = 0;                           // of both
};

}  // namespace warpjet
