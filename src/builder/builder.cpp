#include "builder/builder.hpp"

#include <algorithm>

#include "graph/multi_index.hpp"
#include "module/messages.hpp"

namespace warpjet {

std::nullopt_t Builder::reject(std::string_view method, Parts parts) {
  problem_ = method;
  if (!method.empty()) problem_ += ": ";
  for (const std::string_view part : parts) problem_ += part;
  return std::nullopt;
}

int Builder::addResult(std::optional<Value> value, std::size_t before, std::string_view method) {
  operands_.clear();
  if (value && !checkPossible(value->nodes(), before, method)) value.reset();
  return value ? values_.add(*value) : failed;
}

bool Builder::checkPossible(std::span<const NodeId> results, std::size_t before,
                            std::string_view method) {
  const bool isFull = graph_.isFull() || values_.isFull();
  const auto* why = isFull ? &tooLarge : findImpossible(results, before);
  if (!why) return true;
  wasImpossible_ |= !isFull;
  reject(method, {*why});
  return false;
}

// Returns a message for nodes that a shader can't compute: operations on constants that weren't
// folded, because the result isn't a finite float32; divisions by the constant zero; and noise
// derivatives of such a high order that their code would be endless. Null for other nodes.
const std::string_view* Builder::explainImpossible(NodeId id) const {
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

// Checks the nodes made since `before` and the older nodes that they read. The operands of older
// nodes were checked when they were made.
const std::string_view* Builder::findImpossible(std::span<const NodeId> results,
                                                std::size_t before) {
  needed_.assign(graph_.size() - before, false);
  const auto visit = [&](NodeId id) {
    if (index(id) >= before) needed_[index(id) - before] = true;
    return index(id) < before ? explainImpossible(id) : nullptr;
  };
  for (const NodeId id : results) {
    if (const auto* why = visit(id)) return why;
  }
  for (std::size_t i = needed_.size(); i-- > 0;) {
    if (!needed_[i]) continue;
    const NodeId id{static_cast<std::uint32_t>(before + i)};
    if (const auto* why = explainImpossible(id)) return why;
    for (int k = 0; k < graph_.arity(id); ++k) {
      if (const auto* why = visit(graph_.operand(id, k))) return why;
    }
  }
  return nullptr;
}

int Builder::constant(double value) {
  const NodeId id = graph_.constant(value);
  return addResult(Value(Expression{&graph_, id}), graph_.size(), "val");
}

int Builder::call(int operationIndex, bool isMethod) {
  const Operation& operation = operations[operationIndex];
  const Site site{operation.name, isMethod};
  const std::size_t before = graph_.size();
  if (operation.source == Operation::Source::Composition) {
    const Form& form = forms[operation.index];
    const bool differentiates = std::any_of(form.operands.begin(), form.operands.end(),
                                            [](char letter) { return isInput(Kind{letter}); });
    if (differentiates && !operands_.empty() && readsOpenRepeat(operands_[0].nodes(), true)) {
      operands_.clear();
      reject(site.method, {afterRepeat});
      return failed;
    }
    if (differentiates && !operands_.empty() && !hasAllPartials(operands_[0])) {
      operands_.clear();
      return needsPartials;
    }
  }
  return addResult(apply(operation, site), before, operation.name);
}

std::optional<Value> Builder::apply(const Operation& operation, const Site& site) {
  using Source = Operation::Source;
  switch (operation.source) {
    case Source::Row:
      return applyRow(static_cast<Op>(operation.index), site);
    case Source::Composition:
      return compose(forms[operation.index], site);
    case Source::Vector:
      return makeVector(operation.index, site);
    case Source::MatrixOfColumns:
      return makeMatrix(operation.index, false, site);
    case Source::MatrixOfRows:
      return makeMatrix(operation.index, true, site);
    case Source::Part:
      return takePart(operation.index == 1, site);
  }
  return std::nullopt;
}

int Builder::callFunction(int functionIndex) {
  const std::size_t before = graph_.size();
  const Function& function = graph_.function(static_cast<std::uint32_t>(functionIndex));
  const Site site{function.name, false};
  const auto result = [&]() -> std::optional<Value> {
    if (!checkCount(function.arity, site)) return std::nullopt;
    for (std::size_t i = 0; i < operands_.size(); ++i) {
      if (!fits(Kind::NumberOrVector, operands_[i], i, site)) return std::nullopt;
    }
    const auto shape = commonShape(operands_, site);
    if (!shape) return std::nullopt;
    return fill(graph_, *shape, [&](int i) {
      std::vector<NodeId> arguments;
      for (const Value& operand : operands_)
        arguments.push_back(operand.nodes()[operand.size() == 1 ? 0 : i]);
      return Expression{&graph_, graph_.call(static_cast<std::uint32_t>(functionIndex), arguments)};
    });
  }();
  return addResult(result, before, function.name);
}

int Builder::swizzle(int handle, int count, unsigned indices) {
  const Value from = values_.get(graph_, handle);
  const auto selected = [&]() -> std::optional<Value> {
    Value value(graph_, vectorOf(count));
    for (int i = 0; i < count; ++i) {
      const int k = static_cast<int>(indices >> 2 * i & 3);
      if (!from.shape().isVector() || k >= from.size())
        return reject({}, {shapeName(from.shape()), " has no such components."});
      value.set(i, from.nodes()[k]);
    }
    return value;
  }();
  return addResult(selected, graph_.size(), {});
}

void Builder::comment(std::string_view text) {
  differentiator_.logTo(derived_);
  derived_.clear();
  const NodeId first{static_cast<std::uint32_t>(commentedCount_)};
  const NodeId end{static_cast<std::uint32_t>(graph_.size())};
  commentedCount_ = graph_.size();
  if (first == end) return;
  Comments& comments = module_.comments;
  comments.ranges.push_back({first, end, static_cast<std::uint32_t>(comments.texts.size())});
  comments.texts.emplace_back(text);
}

// Nodes made after the last comment get the comment of the node that they are a derivative of.
void Builder::commentDerivatives() {
  Comments& comments = module_.comments;
  for (const auto& [first, end, origin] : derived_) {
    if (const Comments::Range* range = comments.find(origin))
      comments.ranges.push_back({first, end, std::uint32_t{range->text}});
  }
}

}  // namespace warpjet
