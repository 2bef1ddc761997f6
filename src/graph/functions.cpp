// The named parts of a graph: inputs, functions and their calls. Separate from graph.cpp so that
// this file can be compiled for size.
#include <utility>

#include "graph/graph.hpp"

namespace warpjet {

std::uint32_t Graph::input(std::string_view label, Shape shape) {
  const auto [begin, end] = inputNumbers_.equal_range(label);
  for (auto each = begin; each != end; ++each) {
    if (inputs_[each->second].shape == shape) return each->second;
  }
  const auto number = static_cast<std::uint32_t>(inputs_.size());
  inputs_.push_back({std::string(label), shape});
  inputNumbers_.emplace(label, number);
  return number;
}

std::optional<std::uint32_t> Graph::findInput(std::string_view label) const {
  const auto found = inputNumbers_.lower_bound(label);
  if (found == inputNumbers_.end() || found->first != label) return std::nullopt;
  return found->second;
}

std::uint32_t Graph::sizeOf(std::uint32_t image) {
  for (std::uint32_t i = 0; i < inputs_.size(); ++i) {
    if (inputs_[i].image == image) return i;
  }
  inputs_.push_back({{}, vectorOf(2), image});
  return static_cast<std::uint32_t>(inputs_.size() - 1);
}

std::uint32_t Graph::addFunction(Function function) {
  const auto number = static_cast<std::uint32_t>(functions_.size());
  functionNumbers_.emplace(function.name, number);
  functions_.push_back(std::move(function));
  return number;
}

std::optional<std::uint32_t> Graph::findFunction(std::string_view name) const {
  const auto found = functionNumbers_.find(name);
  if (found == functionNumbers_.end()) return std::nullopt;
  return found->second;
}

NodeId Graph::call(std::uint32_t function, std::span<const NodeId> arguments) {
  std::vector<NodeId> floats;
  for (const NodeId argument : arguments) floats.push_back(convert(argument, ops::Type::Float));
  return intern(Node{{index(makeList(floats)), function}, callOp});
}

NodeId Graph::result(NodeId call, int number) {
  return intern(Node{{index(call), static_cast<std::uint32_t>(number)}, resultOp});
}

NodeId Graph::makeList(std::span<const NodeId> items) {
  NodeId all = items[0];
  for (const NodeId item : items.subspan(1)) all = intern(Node{{index(all), index(item)}, listOp});
  return all;
}

std::vector<NodeId> Graph::list(NodeId id) const {
  std::vector<NodeId> items;
  for (; isList(id); id = operand(id, 0)) items.push_back(operand(id, 1));
  items.push_back(id);
  return {items.rbegin(), items.rend()};
}

void Graph::setPartials(NodeId call, std::span<const NodeId> partials) {
  if (partials_.size() <= index(call)) partials_.resize(index(call) + 1, noNode);
  partials_[index(call)] = makeList(partials);
}

bool Graph::hasPartials(NodeId call) const {
  return index(call) < partials_.size() && partials_[index(call)] != noNode;
}

}  // namespace warpjet
