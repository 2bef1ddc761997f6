// Numbers positions: equal positions have equal numbers, whatever other attributes their vertices
// have. Only equal positions are welded (0 equals -0), not close ones.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace warpjet {

using Position = std::array<float, 3>;

class Welder {
 public:
  // Numbers count from 0 in the order of first occurrence.
  std::uint32_t weld(const Position& position);

  // Returns the position as it first occurred.
  const Position& position(std::uint32_t number) const { return positions_[number]; }

 private:
  std::size_t findSlot(const Position& position) const;
  void grow();

  std::vector<Position> positions_;
  std::vector<std::uint32_t> table_;  // open addressing; an entry is a number plus one
};

}  // namespace warpjet
