// What no shader can compute, found when a call of the builder ends.
#include "builder/builder.hpp"
#include "graph/multi_index.hpp"
#include "module/sentences.hpp"

namespace warpjet {

bool Builder::checkPossible(std::span<const NodeId> results, std::size_t before,
                            std::string_view method) {
  const bool isFull = graph_.full() || values_.full();
  const auto* why = isFull ? &tooLarge : findImpossible(results, before);
  if (!why) return true;
  wasImpossible_ |= !isFull;
  refuse(method, {*why});
  return false;
}

// What a shader cannot compute: an operation on constants that folding left alone, since its result
// is not a finite float32, or a division by a constant zero; and derivatives of noise of so high an
// order that their text would know no end.
const std::string_view* Builder::impossible(NodeId id) const {
  if (graph_.isResult(id)) {
    const Function& function = graph_.function(graph_.operand(id, 0));
    const int derivative = graph_.resultNumber(id) / function.values;
    const bool isTooHigh = MultiIndices::orderOf(function.variables, derivative) > 3;
    return isTooHigh ? &tooHighOrder : nullptr;
  }
  if (!graph_.isOperation(id) || graph_.known(id)) return nullptr;
  if (ops::has(graph_.node(id).op, ops::Trait::Divides)) {
    const NodeId divisor = graph_.operand(id, 1);
    const bool isConstant = graph_.isConstant(divisor);
    if (isConstant && static_cast<float>(graph_.value(divisor)) == 0) return &dividesByZero;
  }
  for (int i = 0; i < graph_.arity(id); ++i) {
    if (!graph_.known(graph_.operand(id, i))) return nullptr;
  }
  return &notFinite;
}

// Searches the nodes since `before`, and judges the earlier ones that they use; what is below those
// was searched when it was made.
const std::string_view* Builder::findImpossible(std::span<const NodeId> results,
                                                std::size_t before) {
  needed_.assign(graph_.size() - before, false);
  const auto visit = [&](NodeId id) {
    if (index(id) >= before) needed_[index(id) - before] = true;
    return index(id) < before ? impossible(id) : nullptr;
  };
  for (const NodeId id : results) {
    if (const auto* why = visit(id)) return why;
  }
  for (std::size_t i = needed_.size(); i-- > 0;) {
    if (!needed_[i]) continue;
    const NodeId id{static_cast<std::uint32_t>(before + i)};
    if (const auto* why = impossible(id)) return why;
    for (int k = 0; k < graph_.arity(id); ++k) {
      if (const auto* why = visit(graph_.operand(id, k))) return why;
    }
  }
  return nullptr;
}

}  // namespace warpjet
