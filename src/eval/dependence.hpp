// Determines how nodes depend on inputs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// Nodes are added in ascending order.
class Dependence {
 public:
  // `varying` are the numbers of the inputs that vary.
  Dependence(const Graph& graph, std::span<const std::uint32_t> varying)
      : graph_(graph), varying_(varying), kinds_(graph.size()) {}

  void add(NodeId id) { kinds_[index(id)] = kindOf(id); }
  // Adds the nodes that the graph has got since the last call, or since the start.
  void addNew() {
    for (auto i = static_cast<std::uint32_t>(kinds_.size()); i < graph_.size(); ++i)
      kinds_.push_back(kindOf(NodeId{i}));
  }

  bool isVarying(NodeId id) const { return kinds_[index(id)] == Kind::Varying; }
  bool isInLoop(NodeId id) const { return kinds_[index(id)] == Kind::InLoop; }

 private:
  enum class Kind : std::uint8_t { Constant, Varying, InLoop };

  Kind kindOf(NodeId id) const {
    if (graph_.isLocal(id)) return Kind::InLoop;
    if (graph_.isInput(id)) {
      const std::uint32_t input = graph_.node(id).operands[0];
      return std::find(varying_.begin(), varying_.end(), input) == varying_.end() ? Kind::Constant
                                                                                  : Kind::Varying;
    }
    Kind kind = Kind::Constant;
    for (int i = 0; i < graph_.arity(id); ++i)
      kind = std::max(kind, kinds_[index(graph_.operand(id, i))]);
    // A step function, such as floor, is constant but for its jumps.
    const bool isStep = graph_.isOperation(id) && ops::isStep(graph_.node(id).op);
    return isStep && kind == Kind::Varying ? Kind::Constant : kind;
  }

  const Graph& graph_;
  std::span<const std::uint32_t> varying_;
  std::vector<Kind> kinds_;
};

}  // namespace warpjet
