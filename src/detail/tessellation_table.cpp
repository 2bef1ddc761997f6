#include "detail/tessellation_table.hpp"

#include <cassert>
#include <cstring>

namespace warpjet {

namespace {

std::uint32_t bitsOf(float number) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

}  // namespace

bool TessellationTable::makeNext() {
  constexpr std::size_t base = pieceCounts.size();
  const auto [inner, triangles, flips] =
      makeTessellation({pieceCounts[count_ / (base * base)], pieceCounts[count_ / base % base],
                        pieceCounts[count_ % base]});
  assert(inner.size() < 1 << 11 && flips.size() < 1 << 10 && triangles.size() < 1 << 11);
  words_[2 * count_] = static_cast<std::uint32_t>(words_.size());
  words_[2 * count_ + 1] =
      static_cast<std::uint32_t>(inner.size() << 21 | flips.size() << 11 | triangles.size());
  for (const auto& weights : inner) {
    for (const float weight : weights) words_.push_back(bitsOf(weight));
  }
  for (const auto& [a, b, c] : triangles) words_.push_back(a | b << 10 | c << 20);
  for (const Flip& flip : flips) {
    for (const float factor : flip.factors) words_.push_back(bitsOf(factor));
  }
  return ++count_ < size_;
}

}  // namespace warpjet
