#include "graph/simplify.hpp"

#include <utility>

#include "graph/match.hpp"
#include "graph/rotations.hpp"

namespace warpjet {

namespace {

// Out of line, since most operations are not replaced.
[[gnu::noinline]] std::optional<NodeId> replace(Graph& graph, Op op,
                                                const Operands<NodeId>& operands,
                                                std::uint32_t candidates) {
  patterns::Bindings bindings;
  const patterns::Rule* rule = patterns::findRule(graph, op, operands, candidates, bindings);
  if (!rule) return {};
  const auto apply = [&](Op made, const Operands<NodeId>& x) { return graph.apply(made, x); };
  return patterns::build(graph, &patterns::rules.items[rule->to], bindings, apply);
}

}  // namespace

std::optional<NodeId> simplify(Graph& graph, Op op, Operands<NodeId>& operands) {
  // The constant of a sum or product comes last, as people write it.
  if (graph.isConstant(operands[0]) && ops::has(op, ops::Trait::Commutative))
    std::swap(operands[0], operands[1]);

  if (const std::uint32_t candidates = patterns::findCandidates(graph, op, operands)) {
    if (const auto found = replace(graph, op, operands, candidates)) return found;
  }
  if (op == ops::find("add") || op == ops::find("sub"))
    return cancelRotation(graph, op, operands[0], operands[1]);
  return {};
}

}  // namespace warpjet
