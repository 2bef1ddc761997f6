#include "source/loops.hpp"

#include <array>

#include "source/fold.hpp"

namespace warpjet::source {

// Goes to the next step, and computes the states that have been queried, for which others may have
// to be queried.
void LoopRun::advance() {
  std::vector<std::optional<double>> nexts(states_.size());
  for (bool hasNew = true; hasNew;) {
    hasNew = false;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      if (!isQueried_[i] || nexts[i]) continue;
      const std::vector<bool> before = isQueried_;
      nexts[i] = value(all_[i].atEnd);
      if (nexts[i]) nexts[i] = representAs(recorder_.base(all_[i].start), *nexts[i]);
      hasNew = hasNew || before != isQueried_;
    }
  }
  states_ = std::move(nexts);
  ++step_;
}

std::optional<double> LoopRun::find(Id id, int depth) {
  if (recorder_.isConstant(id)) return recorder_.value(id);
  if (depth == 0 || --budget_ == 0) return std::nullopt;
  const Operation& operation = recorder_.at(id);
  const auto packed = static_cast<std::uint32_t>(operation.value);
  if (operation.code == Code::StepNumber || operation.code == Code::State) {
    if (packed >> 16 != loop_) return std::nullopt;
    if (operation.code == Code::StepNumber) return step_;
    const std::size_t state = packed >> 8 & 255;
    if (state >= states_.size()) return std::nullopt;
    isQueried_[state] = true;
    return states_[state];
  }
  const auto known = known_.find(index(id));
  if (known != known_.end()) return known->second;
  const auto operands = recorder_.operands(id);
  std::array<double, 3> values{};
  if (operands.empty() || operands.size() > values.size()) return std::nullopt;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const auto value = find(operands[i], depth - 1);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  auto result = fold(operation.code, {values.data(), operands.size()});
  if (operation.code == Code::Not) result = values[0] == 0;
  if (!result) return std::nullopt;
  return known_.emplace(index(id), representAs(operation.base, *result)).first->second;
}

}  // namespace warpjet::source
