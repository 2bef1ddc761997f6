// Lists all tessellations for compute passes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "detail/tessellation.hpp"

namespace warpjet {

// Makes tessellations one by one, since all together take a second or more.
class TessellationTable {
 public:
  // Appends a tessellation. Returns false if it was the last one.
  bool makeNext();

  // Starts with two words for each tessellation, ordered by the numbers of pieces of sides 0, 1 and
  // 2, of which side 0 is the most significant:
  // - the index of the tessellation's data;
  // - (number of inner points) << 21 | (number of flips) << 11 | number of triangles.
  // Then the data: three weights for each inner point, as the bits of floats; one word for each
  // triangle, with 10 bits for each corner, the first corner in the lowest bits; and the three
  // factors of each flip, as the bits of floats.
  const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  static constexpr std::size_t size_ = pieceCounts.size() * pieceCounts.size() * pieceCounts.size();

  std::size_t count_ = 0;
  std::vector<std::uint32_t> words_ = std::vector<std::uint32_t>(2 * size_);
};

}  // namespace warpjet
