// A stream of words: written by `save`, read by `load`.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace warpjet {

class WordWriter {
 public:
  // Appends space for that many words, which must be filled before the next call; returns it.
  std::uint32_t* extend(std::size_t words) {
    words_.resize(words_.size() + words);
    return words_.data() + (words_.size() - words);
  }
  void number(std::size_t value) { words_.push_back(static_cast<std::uint32_t>(value)); }
  void text(std::string_view text) {
    number(text.size());
    const std::size_t first = words_.size();
    words_.resize(first + (text.size() + 3) / 4);
    if (!text.empty()) std::memcpy(&words_[first], text.data(), text.size());
  }

  std::vector<std::uint32_t> take() { return std::move(words_); }

 private:
  std::vector<std::uint32_t> words_;
};

class WordReader {
 public:
  explicit WordReader(std::span<const std::uint32_t> words) : rest_(words) {}

  std::uint32_t number() {
    const std::uint32_t value = rest_[0];
    rest_ = rest_.subspan(1);
    return value;
  }
  const std::uint32_t* block(std::size_t words) {
    const std::uint32_t* const first = rest_.data();
    rest_ = rest_.subspan(words);
    return first;
  }
  std::string text() {
    const std::size_t size = number(), words = (size + 3) / 4;
    std::string text(size, '\0');
    if (size > 0) std::memcpy(text.data(), rest_.data(), size);
    rest_ = rest_.subspan(words);
    return text;
  }

 private:
  std::span<const std::uint32_t> rest_;
};

}  // namespace warpjet
