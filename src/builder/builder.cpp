#include "builder/builder.hpp"

#include <algorithm>

#include "module/sentences.hpp"

namespace warpjet {

std::nullopt_t Builder::refuse(std::string_view method, Parts parts) {
  problem_ = method;
  if (!method.empty()) problem_ += ": ";
  for (const std::string_view part : parts) problem_ += part;
  return std::nullopt;
}

int Builder::finish(std::optional<Value> value, std::size_t before, std::string_view method) {
  operands_.clear();
  if (value && !checkPossible(value->nodes(), before, method)) value.reset();
  return value ? values_.add(*value) : failed;
}

int Builder::constant(double value) {
  const NodeId id = graph_.constant(value);
  return finish(Value(Expression{&graph_, id}), graph_.size(), "val");
}

int Builder::call(int number, bool isMethod) {
  const Operation& operation = operations[number];
  const Site site{operation.name, isMethod};
  const std::size_t before = graph_.size();
  if (operation.source == Operation::Source::Composition) {
    const Form& form = forms[operation.index];
    const bool differentiates = std::any_of(form.operands.begin(), form.operands.end(),
                                            [](char letter) { return isInput(Kind{letter}); });
    if (differentiates && !operands_.empty() && isWithinRepeat(operands_[0].nodes(), true)) {
      operands_.clear();
      refuse(site.method, {afterRepeat});
      return failed;
    }
    if (differentiates && !operands_.empty() && !hasAllPartials(operands_[0])) {
      operands_.clear();
      return needsPartials;
    }
  }
  return finish(apply(operation, site), before, operation.name);
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

int Builder::callFunction(int number) {
  const std::size_t before = graph_.size();
  const Function& function = graph_.function(static_cast<std::uint32_t>(number));
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
      return Expression{&graph_, graph_.call(static_cast<std::uint32_t>(number), arguments)};
    });
  }();
  return finish(result, before, function.name);
}

int Builder::swizzle(int handle, int count, unsigned indices) {
  const Value from = values_.get(graph_, handle);
  const auto selected = [&]() -> std::optional<Value> {
    Value value(graph_, vectorOf(count));
    for (int i = 0; i < count; ++i) {
      const int k = static_cast<int>(indices >> 2 * i & 3);
      if (!from.shape().isVector() || k >= from.size())
        return refuse({}, {shapeName(from.shape()), " has no such components."});
      value.set(i, from.nodes()[k]);
    }
    return value;
  }();
  return finish(selected, graph_.size(), {});
}

void Builder::comment(std::string_view text) {
  differentiator_.logTo(derived_);
  derived_.clear();
  const NodeId first{static_cast<std::uint32_t>(commented_)};
  const NodeId end{static_cast<std::uint32_t>(graph_.size())};
  commented_ = graph_.size();
  if (first == end) return;
  Comments& comments = module_.comments;
  comments.ranges.push_back({first, end, static_cast<std::uint32_t>(comments.texts.size())});
  comments.texts.emplace_back(text);
}

// What was made after the last comment has that of the node that it is a derivative of.
void Builder::commentDerivatives() {
  Comments& comments = module_.comments;
  for (const auto& [first, end, of] : derived_) {
    if (const Comments::Range* range = comments.find(of))
      comments.ranges.push_back({first, end, std::uint32_t{range->text}});
  }
}

}  // namespace warpjet
