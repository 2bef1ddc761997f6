// The values of all variables at one point of the execution. If a condition is unknown, each side
// has a branch: closing it returns the changes made in it and restores the previous state.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "source/recorder.hpp"

namespace warpjet::source {

class Store {
 public:
  using Slot = std::uint32_t;

  struct Change {
    Slot slot;
    Id value;
  };
  using Changes = std::vector<Change>;

  Slot allocate(std::size_t count, Id value) {
    const auto first = static_cast<Slot>(values_.size());
    values_.resize(values_.size() + count, value);
    depths_.resize(values_.size(), depth());
    return first;
  }

  // Declares variables in the current branch, after which they don't exist: `close` omits them.
  void declare(Slot first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) depths_[first + i] = depth();
  }

  Id get(Slot slot) const { return values_[slot]; }

  void set(Slot slot, Id value) {
    if (values_[slot] == value) return;
    if (!marks_.empty()) log_.push_back({slot, values_[slot]});
    values_[slot] = value;
  }

  void open() { marks_.push_back(log_.size()); }

  // Returns a point in the history of changes, for `revise`.
  std::size_t now() const { return log_.size(); }

  // Replaces the values of the slots that have changed since that point. No branch that was open
  // then may be closed.
  template <class Revised>
  void revise(std::size_t since, const Revised& revised) {
    const std::size_t end = now();
    for (std::size_t i = since; i < end; ++i) set(log_[i].slot, revised(values_[log_[i].slot]));
  }

  // Returns the changes since `open`, one per slot, in order.
  Changes close() {
    Changes changes;
    for (std::size_t i = log_.size(); i-- > marks_.back();) {
      const auto [slot, before] = log_[i];
      if (depths_[slot] < depth()) changes.push_back({slot, values_[slot]});
      values_[slot] = before;
    }
    log_.resize(marks_.back());
    marks_.pop_back();
    // If a slot changed several times, the last change to be undone has the latest value.
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return a.slot < b.slot; });
    changes.erase(std::unique(changes.begin(), changes.end(),
                              [](const Change& a, const Change& b) { return a.slot == b.slot; }),
                  changes.end());
    return changes;
  }

  std::uint32_t depth() const { return static_cast<std::uint32_t>(marks_.size()); }

 private:
  std::vector<Id> values_;
  std::vector<std::uint32_t> depths_;  // the number of open branches when it was declared
  Changes log_;
  std::vector<std::size_t> marks_;
};

}  // namespace warpjet::source
