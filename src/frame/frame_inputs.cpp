#include "frame/frame_inputs.hpp"

#include <string>

#include "frame/frame.hpp"

namespace warpjet {

NodeId FrameInputs::pass(NodeId id) {
  if (graph_.isLeaf(id)) return id;
  NodeId passed = noNode;
  switch (graph_.type(id)) {
    case ops::Type::Float:
      passed = component(id);
      break;
    case ops::Type::Bool:
      passed = component(graph_.apply(ops::find("float"), {id}));
      if (passed != noNode) passed = graph_.apply(ops::find("bool"), {passed});
      break;
    case ops::Type::Int:
      passed =
          fromHalves(half(ops::find("shiftRight"), id, 16), half(ops::find("bitAnd"), id, 0xffff));
      break;
  }
  return passed == noNode ? id : passed;
}

// Returns the component that passes this float, or `noNode` if all frame inputs are used.
NodeId FrameInputs::component(NodeId value) {
  std::size_t i = 0;
  while (i < values_.size() && values_[i] != value) ++i;
  if (i == maxFrameValues) return noNode;
  if (i == values_.size()) values_.push_back(value);
  const std::string label = frameLabel + std::to_string(i / 4);
  return graph_.component(graph_.input(label, vectorOf(4)), static_cast<int>(i % 4));
}

// Returns the component that passes half of an integer's bits: those that are left by an operation
// with `operand`, a shift or a mask.
NodeId FrameInputs::half(Op op, NodeId whole, double operand) {
  const NodeId bits = graph_.apply(op, {whole, graph_.intConstant(operand)});
  return component(graph_.apply(ops::find("intToFloat"), {bits}));
}

// Combines the halves by a product and a sum, since GLSL ES 1.00 has no bitwise operations.
NodeId FrameInputs::fromHalves(NodeId high, NodeId low) {
  if (high == noNode || low == noNode) return noNode;
  const NodeId upper = graph_.apply(ops::find("intMult"), {high, graph_.intConstant(0x10000)});
  return graph_.apply(ops::find("intAdd"), {upper, low});
}

}  // namespace warpjet
