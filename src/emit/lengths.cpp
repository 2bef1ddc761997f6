#include "emit/lengths.hpp"

#include <algorithm>

namespace warpjet {

void Lengths::setName(NodeId id, int length) {
  Text& text = texts_[index(id)];
  const int difference = length - text.whereRead;
  text.whereRead = length;
  text.isNamed = true;
  changeReaders(id, difference);
}

void Lengths::removeName(NodeId id) {
  Text& text = texts_[index(id)];
  const int difference = text.operation - text.whereRead;
  text.whereRead = text.operation;
  text.isNamed = false;
  changeReaders(id, difference);
}

void Lengths::measure(std::span<const NodeId> nodes) {
  gatherUsers(nodes);
  for (const NodeId id : nodes) {
    Text& text = texts_[index(id)];
    if (graph_.isOperation(id)) {
      text.depth = static_cast<std::uint8_t>(depthOfOperation(id));
      if (text.depth <= maxLevels) text.operation = measureOperation(id, maxLevels);
    }
    if (!text.isNamed) text.whereRead = graph_.isInput(id) ? lengthOfInput(id) : text.operation;
  }
}

// Groups the readers by the node that they read, by counting sort: counts them, then places each
// after the readers of the preceding nodes.
void Lengths::gatherUsers(std::span<const NodeId> nodes) {
  userEnds_.assign(graph_.size() + 2, 0);
  const auto forEachRead = [&](auto visit) {
    for (const NodeId id : nodes) {
      if (!graph_.isOperation(id)) continue;
      for (int i = 0; i < graph_.arity(id); ++i) visit(id, index(graph_.operand(id, i)));
    }
  };
  forEachRead([&](NodeId, std::uint32_t read) { ++userEnds_[read + 2]; });
  for (std::size_t i = 2; i < userEnds_.size(); ++i) userEnds_[i] += userEnds_[i - 1];
  users_.resize(userEnds_.back());
  forEachRead([&](NodeId id, std::uint32_t read) { users_[userEnds_[read + 1]++] = id; });
}

// Adds the difference to the lengths of all expressions that contain the node. The recursion is no
// deeper than the nesting of measured expressions.
void Lengths::changeReaders(NodeId id, int difference) {
  if (users_.empty()) return;
  const std::uint32_t end = userEnds_[index(id) + 1];
  for (std::uint32_t i = userEnds_[index(id)]; i < end; ++i) {
    Text& user = texts_[index(users_[i])];
    if (user.depth > maxLevels) continue;
    user.operation += difference;
    user.depth = static_cast<std::uint8_t>(depthOfOperation(users_[i]));
    if (user.isNamed) continue;
    user.whereRead += difference;
    changeReaders(users_[i], difference);
  }
}

int Lengths::whereRead(NodeId id, int levels) const {
  const Text& text = texts_[index(id)];
  if (text.isNamed || text.depth <= levels) return text.whereRead;
  return levels == 0 ? typicalNumber : measureOperation(id, levels);
}

int Lengths::lengthOfOperation(NodeId id, int levels) const {
  const Text& text = texts_[index(id)];
  return text.depth <= levels ? text.operation : measureOperation(id, levels);
}

int Lengths::measureOperation(NodeId id, int levels) const {
  const int arity = graph_.arity(id);
  int total = around(ops::spelling(graph_.node(id).op, language_), arity);
  for (int i = 0; i < arity; ++i) total += whereRead(graph_.operand(id, i), levels - 1);
  return total;
}

int Lengths::depthOfOperation(NodeId id) const {
  int deepest = 0;
  for (int i = 0; i < graph_.arity(id); ++i) {
    const Text& operand = texts_[index(graph_.operand(id, i))];
    if (!operand.isNamed) deepest = std::max<int>(deepest, operand.depth);
  }
  return std::min(deepest, maxLevels) + 1;
}

int Lengths::lengthOfInput(NodeId id) const {
  constexpr int maxLabel = 12;
  const Input& input = graph_.input(graph_.node(id).operands[0]);
  const int label = std::min(static_cast<int>(input.label.size()), maxLabel);
  return input.shape.isNumber() ? label : label + member;
}

}  // namespace warpjet
