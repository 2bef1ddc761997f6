#include "emit/sums.hpp"

#include <algorithm>

namespace warpjet {

namespace {

constexpr Op add = ops::find("add"), sub = ops::find("sub");

// Returns true if the graph simplifies -x to `y`, or the reverse.
bool isNegative(const Graph& graph, NodeId x, NodeId y) {
  if (graph.isConstant(x)) return graph.isConstant(y, -graph.value(x));
  return graph.is(x, ops::find("neg")) && graph.operand(x, 0) == y;
}

// Returns true if the graph simplifies x + y to `sum`, where x is an input.
bool isSum(const Graph& graph, NodeId sum, NodeId x, NodeId y) {
  if (graph.isConstant(y, 0)) return sum == x;
  if (isNegative(graph, y, x)) return graph.isConstant(sum, 0);
  const bool isDifference = graph.is(sum, sub);
  if (!graph.is(sum, add) && !isDifference) return false;
  const NodeId a = graph.operand(sum, 0), b = graph.operand(sum, 1);
  if (isDifference) return a == x && isNegative(graph, y, b);
  return (a == x && b == y) || (a == y && b == x);
}

class Finder {
 public:
  Finder(const Graph& graph, std::span<const Output> outputs)
      : graph_(graph), outputs_(outputs), components_(graph.inputCount()) {
    for (std::uint32_t i = 0; i < graph.size(); ++i) {
      const NodeId id{i};
      if (!graph.isInput(id)) continue;
      const auto [input, component, unused] = graph.node(id).operands;
      components_[input].resize(static_cast<std::size_t>(graph.input(input).shape.size()), noNode);
      components_[input][component] = id;
    }
  }

  std::optional<Sum> find(std::size_t number) const {
    const Output& output = outputs_[number];
    if (!output.shape.isVector()) return {};
    for (const std::uint32_t input : inputsIn(output)) {
      for (std::size_t i = 0; i < number; ++i) {
        if (outputs_[i].shape == output.shape && isSumOf(output, input, outputs_[i]))
          return Sum{input, i};
      }
    }
    return {};
  }

 private:
  // Returns the inputs of the output's shape that may be a term of the output: one of their
  // components is a component of the output, or an operand of such a component.
  std::vector<std::uint32_t> inputsIn(const Output& output) const {
    std::vector<std::uint32_t> inputs;
    const auto consider = [&](NodeId id) {
      if (!graph_.isInput(id)) return;
      const std::uint32_t input = graph_.node(id).operands[0];
      const bool isKnown = std::find(inputs.begin(), inputs.end(), input) != inputs.end();
      if (!isKnown && graph_.input(input).shape == output.shape) inputs.push_back(input);
    };
    for (const NodeId id : output.components) {
      consider(id);
      for (int i = 0; i < graph_.arity(id); ++i) consider(graph_.operand(id, i));
    }
    return inputs;
  }

  bool isSumOf(const Output& output, std::uint32_t input, const Output& term) const {
    bool differs = false;
    for (std::size_t i = 0; i < output.components.size(); ++i) {
      const NodeId x = components_[input][i];
      if (x == noNode || !isSum(graph_, output.components[i], x, term.components[i])) return false;
      differs |= output.components[i] != x;
    }
    return differs;
  }

  const Graph& graph_;
  std::span<const Output> outputs_;
  std::vector<std::vector<NodeId>> components_;  // by input: its nodes
};

}  // namespace

std::vector<std::optional<Sum>> findSums(const Graph& graph, std::span<const Output> outputs) {
  const Finder finder(graph, outputs);
  std::vector<std::optional<Sum>> sums;
  for (std::size_t i = 0; i < outputs.size(); ++i) sums.push_back(finder.find(i));
  return sums;
}

}  // namespace warpjet
