// The inputs that pass the frame constants to the shader.
#pragma once

#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

class FrameInputs {
 public:
  explicit FrameInputs(Graph& graph) : graph_(graph) {}

  // Returns the node that the shader reads in place of `id`, or `id` itself if all frame inputs are
  // used. Frame inputs are floats: a condition is passed as 1 or 0. An integer is passed as two
  // floats, its upper and its lower 16 bits, since a float has only 24 bits.
  NodeId pass(NodeId id);

  // Returns the values of the components that are used.
  const std::vector<NodeId>& values() const { return values_; }
  std::uint32_t count() const { return static_cast<std::uint32_t>((values_.size() + 3) / 4); }

 private:
  NodeId component(NodeId value);
  NodeId half(Op op, NodeId whole, double operand);
  NodeId fromHalves(NodeId high, NodeId low);

  Graph& graph_;
  std::vector<NodeId> values_;
};

}  // namespace warpjet
