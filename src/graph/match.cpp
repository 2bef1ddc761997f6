#include "graph/match.hpp"

#include <bit>

namespace warpjet::patterns {

namespace {

bool matches(const Graph& graph, const Item* item, NodeId id, Bindings& bindings) {
  switch (item->kind) {
    case Kind::Anything:
      return bindings.bind(item->number, id);
    case Kind::Computed:
      return !graph.isConstant(id) && bindings.bind(item->number, id);
    case Kind::Constant:
      return graph.isConstant(id) && bindings.bind(item->number, id);
    case Kind::Literal:
      return graph.known(id) == item->value;
    default:
      break;
  }
  if (!graph.is(id, item->op())) return false;
  const Item* operand = item + 1;
  for (int i = 0; i < arities[index(item->op())]; ++i, operand += operand->size) {
    if (!matches(graph, operand, graph.operand(id, i), bindings)) return false;
  }
  return true;
}

bool matches(const Graph& graph, const Rule& rule, int arity, const Operands<NodeId>& operands,
             Bindings& bindings) {
  bindings.clear();
  const Item* item = &rules.items[rule.from] + 1;
  for (int i = 0; i < arity; ++i, item += item->size) {
    // A named number needs no check: findCandidates has compared it already.
    if (item->kind == Kind::Literal && item->type == ops::Type::Float) continue;
    const bool isMatch = item->kind == Kind::Anything ? bindings.bind(item->number, operands[i])
                                                      : matches(graph, item, operands[i], bindings);
    if (!isMatch) return false;
  }
  return !rule.hasCondition || valueOf(graph, &rules.items[rule.when], bindings) != 0;
}

}  // namespace

double valueOf(const Graph& graph, const Item* item, const Bindings& bindings) {
  switch (item->kind) {
    case Kind::Literal:
      return item->value;
    case Kind::Function:
      return item->function->valueOf(valueOf(graph, item + 1, bindings));
    case Kind::Operation:
      break;
    default:
      return graph.value(bindings[item->number]);
  }
  Operands<double> operands{};
  const Item* operand = item + 1;
  for (int i = 0; i < arities[index(item->op())]; ++i, operand += operand->size)
    operands[i] = valueOf(graph, operand, bindings);
  return ops::valueOf(item->op(), operands);
}

const Rule* findRule(const Graph& graph, Op op, const Operands<NodeId>& operands,
                     std::uint32_t candidates, Bindings& bindings) {
  const std::size_t first = rules.buckets[rules.bucketOf[index(op)]].first;
  for (; candidates != 0; candidates &= candidates - 1) {
    const Rule& rule = rules.all[first + std::countr_zero(candidates)];
    if (matches(graph, rule, arities[index(op)], operands, bindings)) return &rule;
  }
  return nullptr;
}

}  // namespace warpjet::patterns
