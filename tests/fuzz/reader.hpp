// Reads an input of the fuzzer as numbers and texts; past its end everything is zero or empty.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

namespace warpjet {

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  bool isAtEnd() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const std::uint8_t first = bytes_[0];
    bytes_ = bytes_.subspan(1);
    return first;
  }

  // Returns 0 to n - 1, for n up to 256.
  int below(std::size_t n) { return static_cast<int>(byte() % n); }

  template <class Number>
  Number number() {
    Number value{};
    const std::size_t size = std::min(sizeof value, bytes_.size());
    if (size > 0) std::memcpy(&value, bytes_.data(), size);
    bytes_ = bytes_.subspan(size);
    return value;
  }

  std::string text(std::size_t length) {
    length = std::min(length, bytes_.size());
    const std::string all(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(length));
    bytes_ = bytes_.subspan(length);
    return all;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

}  // namespace warpjet
