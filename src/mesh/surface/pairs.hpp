// A flat table of pairs of numbers: open addressing in one array, since a refinement looks up
// several pairs for each new triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/none.hpp"

namespace warpjet {

class Pairs {
 public:
  // Returns the number of the ordered pair. A new pair gets the number `next`.
  std::uint32_t findOrAdd(std::uint32_t a, std::uint32_t b, std::uint32_t next) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slots_[placeOf(a, b)];
    if (slot.number != none) return slot.number;
    slot = {a, b, next};
    ++count_;
    return next;
  }

  // Returns the number of the ordered pair; `none` if it was not added.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const {
    return slots_.empty() ? none : slots_[placeOf(a, b)].number;
  }

 private:
  struct Slot {
    std::uint32_t a = 0, b = 0, number = none;
  };

  std::size_t placeOf(std::uint32_t a, std::uint32_t b) const {
    // Multiply and xor-shift, as in Steele and Vigna's splitmix64.
    std::uint64_t h = (a | std::uint64_t{b} << 32) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32)) * 0xbf58476d1ce4e5b9u;
    const std::size_t mask = slots_.size() - 1;
    std::size_t place = static_cast<std::size_t>(h ^ (h >> 29)) & mask;
    while (slots_[place].number != none && (slots_[place].a != a || slots_[place].b != b))
      place = (place + 1) & mask;
    return place;
  }

  void grow() {
    std::vector<Slot> old(slots_.empty() ? 1024 : 2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.number != none) slots_[placeOf(slot.a, slot.b)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace warpjet
