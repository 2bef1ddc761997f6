// Finds duplicates among millions of elements: an open-addressing table of indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "graph/none.hpp"

namespace warpjet {

// Mixes the bits of two words well enough for a table whose size is a power of two (splitmix64, by
// Sebastiano Vigna, in the public domain).
constexpr std::uint64_t mixBits(std::uint64_t a, std::uint64_t b) {
  std::uint64_t z = a + 0x9E3779B97F4A7C15 * (b + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

// Stores only indices; the caller holds the elements.
class Buckets {
 public:
  // Makes a table for at most `maxCount` distinct elements, with which it is half full.
  explicit Buckets(std::size_t maxCount) {
    std::size_t size = 2;
    while (size < maxCount * 2) size *= 2;
    slots_.assign(size, none);
  }

  // Returns the index of an equal element; if there is none, adds `index` and returns it.
  template <typename IsEqual>
  std::uint32_t findOrAdd(std::uint64_t hash, std::uint32_t index, IsEqual isEqual) {
    for (auto i = static_cast<std::size_t>(hash);; ++i) {
      std::uint32_t& slot = slots_[i & (slots_.size() - 1)];
      if (slot == none) slot = index;
      if (slot == index || isEqual(slot)) return slot;
    }
  }

 private:
  std::vector<std::uint32_t> slots_;
};

}  // namespace warpjet
