// All tessellations as numbers for compute passes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "detail/tessellation.hpp"

namespace warpjet {

// Made one by one, since all together take more than half a second.
class TessellationTable {
 public:
  // Appends a tessellation. Returns false if it was the last one.
  bool makeNext();

  // Two words for each tessellation, in ascending order of its pieces, of which those of side 0
  // count most: the place of its data, and 2^16 times its number of inner points plus that of its
  // triangles. Then the data: three weights for each inner point, as the bits of floats, and a word
  // for each triangle, with 10 bits for each corner, the first one lowest.
  const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  static constexpr std::size_t size_ = pieceCounts.size() * pieceCounts.size() * pieceCounts.size();

  std::size_t made_ = 0;
  std::vector<std::uint32_t> words_ = std::vector<std::uint32_t>(2 * size_);
};

}  // namespace warpjet
