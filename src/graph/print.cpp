#include "graph/print.hpp"

#include <array>
#include <cstdio>

#include "graph/reachable.hpp"

namespace warpjet {

namespace {

std::string numberText(double value) {
  std::array<char, 32> text{};
  for (int digits = 6; digits <= 17; digits += 11) {
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    if (std::stod(text.data()) == value) break;
  }
  return text.data();
}

std::string inputName(const Graph& graph, const Node& node) {
  const auto [number, component, unused] = node.operands;
  const Input& input = graph.input(number);
  const std::string label =
      input.image ? "size of " + graph.input(*input.image).label : input.label;
  if (input.shape.isNumber() || input.shape == imageShape) return label;
  if (input.shape.isVector()) return label + "." + "xyzw"[component];
  return label + "[" + std::to_string(component) + "]";
}

std::string joinNames(const Graph& graph, const std::vector<NodeId>& ids) {
  std::string all;
  for (const NodeId id : ids) all += (all.empty() ? "" : ", ") + nameOf(graph, id);
  return all;
}

std::string line(const Graph& graph, NodeId id) {
  const Node& node = graph.node(id);
  if (graph.isCall(id))
    return "call " + graph.function(id).name + "(" + joinNames(graph, graph.arguments(id)) + ")";
  if (graph.isResult(id))
    return "result " + std::to_string(graph.resultNumber(id)) + " of " +
           nameOf(graph, graph.operand(id, 0));
  if (graph.isOutcome(id))
    return nameOf(graph, graph.operand(id, 1)) + " after " + nameOf(graph, graph.operand(id, 0));
  if (graph.isFold(id)) {
    const Loop& loop = graph.loop(graph.loopOf(id));
    std::string all =
        loop.isCounted() ? std::to_string(loop.steps) + " times" : "until the first state is 1";
    for (const auto& [local, start, next] : graph.states(id))
      all += "; " + nameOf(graph, local) + " from " + nameOf(graph, start) + " to " +
             nameOf(graph, next);
    return all;
  }
  std::vector<NodeId> operands;
  for (int i = 0; i < graph.arity(id); ++i) operands.push_back(graph.operand(id, i));
  return std::string(ops::declaration(node.op).name) + "(" + joinNames(graph, operands) + ")";
}

}  // namespace

std::string nameOf(const Graph& graph, NodeId id) {
  const Node& node = graph.node(id);
  if (graph.isConstant(id)) return numberText(graph.value(id));
  if (graph.isInput(id)) return inputName(graph, node);
  if (graph.isStep(id)) return "step" + std::to_string(graph.loopOf(id));
  if (graph.isLocal(id))
    return "state" + std::to_string(graph.loopOf(id)) + "." + std::to_string(node.operands[1]);
  return "n" + std::to_string(index(id));
}

std::string print(const Graph& graph, std::span<const NodeId> roots) {
  std::string all;
  for (const NodeId id : reachable(graph, roots)) {
    const bool isInline = graph.isLeaf(id) || graph.isList(id) || graph.isStateOrList(id);
    if (!isInline) all += nameOf(graph, id) + " = " + line(graph, id) + "\n";
  }
  return all;
}

}  // namespace warpjet
