// The qualifiers of a type, as they were parsed.
#pragma once

#include <string_view>
#include <vector>

#include "source/problems.hpp"

namespace warpjet::source::glsl {

// In their required order.
enum class QualifierRole : std::uint8_t {
  Invariant,
  Interpolation,
  Layout,
  Const,
  Centroid,
  Storage,
  Precision,
};

struct Qualifiers {
  struct Word {
    std::string_view text;
    QualifierRole role;
    Location location;
  };

  std::vector<Word> words{};
  // Set by layouts.
  bool hasLocation = false, isForBlocks = false;
  // Set by a layout that is allowed for blocks, but not for their members.
  bool isWhole = false;

  bool any() const { return !words.empty(); }
  // Returns the qualifier with that role, or an empty word.
  std::string_view word(QualifierRole role) const;
  bool isConst() const { return !word(QualifierRole::Const).empty(); }
};

}  // namespace warpjet::source::glsl
