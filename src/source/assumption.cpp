#include "source/assumption.hpp"

#include <algorithm>

namespace warpjet::source {

namespace {

// Limits the time for conditions with many parts, such as that of a loop with many breaks.
constexpr std::size_t maxFacts = 32;

}  // namespace

Assumption::Assumption(Recorder& recorder, Id condition, bool isTrue) : recorder_(recorder) {
  add(condition, isTrue);
  std::size_t count = 0;
  while (count < facts_.size()) {
    count = facts_.size();
    for (std::size_t i = 0; i < facts_.size(); ++i) addParts(facts_[i]);
  }
}

void Assumption::add(Id condition, bool isTrue) {
  if (recorder_.at(condition).code == Code::Not)
    return add(recorder_.operands(condition)[0], !isTrue);
  if (facts_.size() < maxFacts && !truth(condition)) facts_.push_back({condition, isTrue});
}

// All parts of a true `and` are true, and those of a false `or` false. If one part of a false `and`
// is true, the other is false; correspondingly for a true `or`.
void Assumption::addParts(Fact fact) {
  const Code code = recorder_.at(fact.condition).code;
  if (code != Code::And && code != Code::Or) return;
  const auto parts = recorder_.operands(fact.condition);
  const bool areAllKnown = fact.isTrue == (code == Code::And);
  if (areAllKnown || truth(parts[1]) == !fact.isTrue) add(parts[0], fact.isTrue);
  if (areAllKnown || truth(parts[0]) == !fact.isTrue) add(parts[1], fact.isTrue);
}

// Finds the truth of a condition: true or false if it follows from the facts, otherwise nullopt.
std::optional<bool> Assumption::truth(Id condition) const {
  if (recorder_.at(condition).code == Code::Not) {
    const auto negated = truth(recorder_.operands(condition)[0]);
    return negated ? std::optional(!*negated) : std::nullopt;
  }
  const auto found = std::find_if(facts_.begin(), facts_.end(),
                                  [&](const Fact& each) { return each.condition == condition; });
  return found == facts_.end() ? std::nullopt : std::optional(found->isTrue);
}

Id Assumption::apply(Id value) const {
  if (recorder_.base(value) == Base::Bool) {
    const auto known = truth(value);
    return known ? recorder_.constant(Base::Bool, *known) : value;
  }
  const Code code = recorder_.at(value).code;
  if (code != Code::IfElse && code != Code::IntIfElse) return value;
  const auto operands = recorder_.operands(value);
  const auto known = truth(operands[0]);
  return known ? apply(operands[*known ? 1 : 2]) : value;
}

}  // namespace warpjet::source
