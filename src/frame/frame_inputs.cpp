#include "frame/frame_inputs.hpp"

#include <string>

#include "frame/frame.hpp"

namespace warpjet {

NodeId FrameInputs::pass(NodeId id) {
  if (graph_.isLeaf(id)) return id;
  NodeId given = noNode;
  switch (graph_.type(id)) {
    case ops::Type::Float:
      given = component(id);
      break;
    case ops::Type::Bool:
      given = component(graph_.apply(ops::find("float"), {id}));
      if (given != noNode) given = graph_.apply(ops::find("bool"), {given});
      break;
    case ops::Type::Int:
      given =
          fromHalves(half(ops::find("shiftRight"), id, 16), half(ops::find("bitAnd"), id, 0xffff));
      break;
  }
  return given == noNode ? id : given;
}

// Returns the component that passes this float, or `noNode` if all frame inputs are used.
NodeId FrameInputs::component(NodeId value) {
  std::size_t place = 0;
  while (place < values_.size() && values_[place] != value) ++place;
  if (place == maxFrameValues) return noNode;
  if (place == values_.size()) values_.push_back(value);
  const std::string label = frameLabel + std::to_string(place / 4);
  return graph_.component(graph_.input(label, vectorOf(4)), static_cast<int>(place % 4));
}

NodeId FrameInputs::half(Op op, NodeId whole, double by) {
  const NodeId bits = graph_.apply(op, {whole, graph_.intConstant(by)});
  return component(graph_.apply(ops::find("intToFloat"), {bits}));
}

// Uses a product and a sum, since GLSL ES 1.00 has no bitwise operations.
NodeId FrameInputs::fromHalves(NodeId high, NodeId low) {
  if (high == noNode || low == noNode) return noNode;
  const NodeId upper = graph_.apply(ops::find("intMult"), {high, graph_.intConstant(0x10000)});
  return graph_.apply(ops::find("intAdd"), {upper, low});
}

}  // namespace warpjet
