#include "emit/writer.hpp"

#include <algorithm>
#include <utility>

#include "emit/literal.hpp"

namespace warpjet {

std::string typeName(ops::Type type, int size) {
  const bool isFloat = type == ops::Type::Float;
  if (size == 1) return isFloat ? "float" : "bool";
  return (isFloat ? "vec" : "bvec") + std::to_string(size);
}

void Writer::name(NodeId id, std::string name) {
  names_[index(id)] = static_cast<std::uint32_t>(texts_.size());
  texts_.push_back(std::move(name));
}

void Writer::writeLeaf(std::string& text, NodeId id) {
  if (graph_.isConstant(id)) {
    const std::string number = literal(graph_.value(id));
    if (number[0] == '-' && text.ends_with('-')) text += ' ';  // "--" is a decrement
    text += number;
    return;
  }
  const auto [input, component, unused] = graph_.node(id).operands;
  text += inputNames_[input];
  if (graph_.input(input).size > 1) text += {'.', "xyzw"[component]};
}

void Writer::open(std::string& text, NodeId id, ops::Precedence loosest) {
  if (isNamed(id)) {
    text += nameOf(id);
  } else if (graph_.isLeaf(id)) {
    writeLeaf(text, id);
  } else {
    const ops::Spelling& spelling = ops::info(graph_.node(id).op).glsl;
    const bool parenthesized = spelling.result < loosest;
    if (parenthesized) text += '(';
    frames_.push_back({id, spelling.text, parenthesized});
  }
}

// Copies the open spellings and opens an operand at each `$`.
void Writer::finish(std::string& text) {
  while (!frames_.empty()) {
    Frame& frame = frames_.back();
    const std::size_t dollar = frame.rest.find('$');
    text += frame.rest.substr(0, dollar);
    if (dollar == frame.rest.npos) {
      if (frame.parenthesized) text += ')';
      frames_.pop_back();
      continue;
    }
    const int operand = frame.rest[dollar + 1] - '0';
    frame.rest.remove_prefix(dollar + 2);
    const ops::Spelling& spelling = ops::info(graph_.node(frame.id).op).glsl;
    open(text, graph_.operand(frame.id, operand), spelling.operands[operand]);
  }
}

void Writer::write(std::string& text, NodeId id) {
  open(text, id, ops::Precedence::Ternary);
  finish(text);
}

void Writer::writeOperation(std::string& text, NodeId id) {
  frames_.push_back({id, ops::info(graph_.node(id).op).glsl.text, false});
  finish(text);
}

bool Writer::isWholeInput(std::span<const NodeId> components) const {
  for (std::size_t i = 0; i < components.size(); ++i) {
    if (!graph_.isInput(components[i])) return false;
    const auto [input, component, unused] = graph_.node(components[i]).operands;
    if (input != graph_.node(components[0]).operands[0] || component != i) return false;
    if (graph_.input(input).size != static_cast<int>(components.size())) return false;
  }
  return true;
}

void Writer::writeVector(std::string& text, std::span<const NodeId> components) {
  if (components.size() == 1) return write(text, components[0]);
  if (isWholeInput(components)) {
    text += inputNames_[graph_.node(components[0]).operands[0]];
    return;
  }
  const bool allEqual = std::all_of(components.begin(), components.end(),
                                    [&](NodeId id) { return id == components[0]; });
  text += typeName(graph_.type(components[0]), static_cast<int>(components.size())) + '(';
  for (std::size_t i = 0; i < (allEqual ? 1 : components.size()); ++i) {
    if (i > 0) text += ", ";
    write(text, components[i]);
  }
  text += ')';
}

}  // namespace warpjet
