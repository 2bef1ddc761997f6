// A set of words, hashed at compile time for fast lookup: every warp checks each of its names.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace warpjet {

class WordSet {
 public:
  // The words are separated by spaces, and few enough to leave half of the table empty.
  constexpr WordSet(std::string_view list) : list_(list) {
    for (std::size_t end = 0, begin; (begin = list.find_first_not_of(' ', end)) != list.npos;) {
      end = std::min(list.find(' ', begin), list.size());
      places_[placeOf(list.substr(begin, end - begin))] = static_cast<std::uint16_t>(begin + 1);
    }
  }
  constexpr WordSet(const char* list) : WordSet(std::string_view(list)) {}

  constexpr bool holds(std::string_view word) const { return places_[placeOf(word)] != 0; }

 private:
  static constexpr std::size_t size = 512;

  // Returns the slot that holds the word, or the empty one where it belongs; open addressing by
  // FNV-1a.
  constexpr std::size_t placeOf(std::string_view word) const {
    std::uint32_t hash = 2166136261u;
    for (const char c : word) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    std::size_t place = (hash ^ hash >> 16) % size;
    while (places_[place] != 0 && !isAt(places_[place] - 1u, word)) place = (place + 1) % size;
    return place;
  }

  constexpr bool isAt(std::size_t begin, std::string_view word) const {
    const std::size_t end = begin + word.size();
    return list_.substr(begin, word.size()) == word && (end == list_.size() || list_[end] == ' ');
  }

  std::string_view list_;
  std::array<std::uint16_t, size> places_{};  // position in the list plus one; 0 if empty
};

}  // namespace warpjet
