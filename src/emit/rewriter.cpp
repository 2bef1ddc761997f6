#include "emit/rewriter.hpp"

#include "graph/reachable.hpp"

namespace warpjet {

std::vector<NodeId> Rewriter::rewrite(std::span<const NodeId> roots) {
  for (const NodeId id : reachable(graph_, roots)) visit(id);
  std::vector<NodeId> replacements;
  for (const NodeId root : roots) replacements.push_back(replacementOf(root));
  return replacements;
}

// Operands are visited before their users.
void Rewriter::visit(NodeId id) {
  if (isKept(id) || graph_.isList(id) || graph_.isStateOrList(id)) return;
  const NodeId first = end();
  replacements_[index(id)] = replace(id);
  const Comments::Range* comment = comments_.find(id);
  if (comment && first != end()) comments_.ranges.push_back({first, end(), comment->text});
}

NodeId Rewriter::replace(NodeId id) {
  if (graph_.isInput(id)) return id;
  if (graph_.isCall(id)) return replaceCall(id);
  if (graph_.isResult(id))
    return graph_.result(replacementOf(graph_.operand(id, 0)), graph_.resultNumber(id));
  if (graph_.isFold(id)) return replaceFold(id);
  if (graph_.isOutcome(id))
    return graph_.outcome(replacementOf(graph_.operand(id, 0)), graph_.operand(id, 1));
  return replaceOperation(id);
}

NodeId Rewriter::replaceFold(NodeId id) {
  std::vector<State> states = graph_.states(id);
  for (auto& [local, start, next] : states) {
    start = replacementOf(start);
    next = replacementOf(next);
  }
  return graph_.fold(graph_.loopOf(id), states);
}

NodeId Rewriter::replaceOperation(NodeId id) {
  const Operands<NodeId> operands = newOperands(id);
  for (int i = 0; i < graph_.arity(id); ++i) {
    if (operands[i] != graph_.operand(id, i)) return graph_.apply(graph_.node(id).op, operands);
  }
  return id;
}

NodeId Rewriter::replaceCall(NodeId id) {
  return graph_.call(graph_.node(id).operands[1], newArguments(id));
}

Operands<NodeId> Rewriter::newOperands(NodeId id) const {
  Operands<NodeId> operands{};
  for (int i = 0; i < graph_.arity(id); ++i) operands[i] = replacementOf(graph_.operand(id, i));
  return operands;
}

std::vector<NodeId> Rewriter::newArguments(NodeId call) const {
  std::vector<NodeId> arguments = graph_.arguments(call);
  for (NodeId& argument : arguments) argument = replacementOf(argument);
  return arguments;
}

}  // namespace warpjet
