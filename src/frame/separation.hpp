// Separates the frame constants of a graph from the values that vary within a frame.
#pragma once

#include <span>
#include <vector>

#include "frame/frame_inputs.hpp"
#include "functions/library.hpp"
#include "graph/expression.hpp"
#include "graph/flags.hpp"

namespace warpjet {

class Separation {
 public:
  // `known` are the numbers of the inputs that are constant within a frame.
  Separation(Graph& graph, Library& library, std::span<const std::uint32_t> known);

  // Operands are visited before their users.
  void visit(NodeId id);

  // Returns the node that replaces `id` in the shader.
  NodeId replacementOf(NodeId id);

  const FrameInputs& inputs() const { return inputs_; }
  // Returns the number of frame constants that were reduced by whole periods.
  std::size_t reduced() const { return reduced_; }

 private:
  // A value as the sum of a varying part, in nodes of the shader, and a frame constant, which has
  // not been passed as an input yet.
  struct Sum {
    NodeId varying = noNode, frame = noNode;
  };

  bool isConstantInFrame(NodeId id) const { return isFrame_[index(id)] || graph_.known(id); }
  void visitOperation(NodeId id);
  Sum sumOf(NodeId id);
  Sum partsOf(NodeId id);
  Sum applyToEach(Op op, Sum sum);
  Sum scaleSum(Op op, Sum sum, NodeId factor);
  NodeId combine(Op op, NodeId x, NodeId y);
  double periodOf(NodeId id) const;
  NodeId reduceBy(double period, NodeId id);
  NodeId remainder(Expression frame, double period);
  NodeId callOf(NodeId call);
  NodeId callWithCells(const Definition& definition, const std::vector<NodeId>& arguments);

  Graph& graph_;
  Library& library_;
  FrameInputs inputs_;
  Flags isKnown_;                     // by input
  Flags isFrame_;                     // by node: true for frame constants
  std::vector<NodeId> replacements_;  // by node
  std::vector<Sum> sums_;             // by node
  std::size_t reduced_ = 0;
};

}  // namespace warpjet
