#include "mesh/surface/weld.hpp"

#include <algorithm>

namespace warpjet {

namespace {

// Returns the bits of a number, in which NaN equals itself. Adding 0 turns -0 into 0.
std::uint32_t bits(float x) { return __builtin_bit_cast(std::uint32_t, x + 0.0f); }

std::size_t hash(const Position& p) {
  // Multiply and xor-shift, as in Steele and Vigna's splitmix64.
  std::uint64_t h = bits(p[0]) | std::uint64_t{bits(p[1])} << 32;
  h = (h ^ bits(p[2]) * 0x94d049bb133111ebu) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 32)) * 0xbf58476d1ce4e5b9u;
  return static_cast<std::size_t>(h ^ (h >> 29));
}

bool areEqual(const Position& a, const Position& b) {
  return std::equal(a.begin(), a.end(), b.begin(),
                    [](float x, float y) { return bits(x) == bits(y); });
}

}  // namespace

std::size_t Welder::findSlot(const Position& position) const {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash(position) & mask;
  while (table_[slot] != 0 && !areEqual(positions_[table_[slot] - 1], position))
    slot = (slot + 1) & mask;
  return slot;
}

std::uint32_t Welder::weld(const Position& position) {
  if (2 * positions_.size() >= table_.size()) grow();
  std::uint32_t& entry = table_[findSlot(position)];
  if (entry == 0) {
    positions_.push_back(position);
    entry = static_cast<std::uint32_t>(positions_.size());
  }
  return entry - 1;
}

void Welder::grow() {
  table_.assign(table_.empty() ? 1024 : 2 * table_.size(), 0);
  for (std::uint32_t i = 0; i < positions_.size(); ++i) table_[findSlot(positions_[i])] = i + 1;
}

}  // namespace warpjet
