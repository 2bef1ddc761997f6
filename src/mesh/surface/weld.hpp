// Positions enter, numbers leave: equal positions have equal numbers, whatever else their vertices
// have. Nothing near is welded, only what is equal (0 and -0 are).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace warpjet {

using Position = std::array<float, 3>;

class Welder {
 public:
  // Numbers count from 0 in the order in which positions come for the first time.
  std::uint32_t weld(const Position& position);

  // As it came for the first time.
  const Position& position(std::uint32_t number) const { return positions_[number]; }

 private:
  std::size_t placeOf(const Position& position) const;
  void grow();

  std::vector<Position> positions_;
  std::vector<std::uint32_t> table_;  // open addressing; an entry is a number plus one
};

}  // namespace warpjet
