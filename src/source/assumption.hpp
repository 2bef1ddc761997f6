// An assumption is what follows from the truth of a condition. A branch knows it, so that a choice
// that was made by the same condition, or by a part of it, is known there.
#pragma once

#include <optional>
#include <vector>

#include "source/recorder.hpp"

namespace warpjet::source {

class Assumption {
 public:
  Assumption(Recorder& recorder, Id condition, bool isTrue);

  // Returns the value that another has under the assumption, as far as it is known.
  Id apply(Id value) const;

 private:
  struct Fact {
    Id condition;
    bool isTrue;
  };

  void add(Id condition, bool isTrue);
  void addParts(Fact fact);
  std::optional<bool> truth(Id condition) const;

  Recorder& recorder_;
  std::vector<Fact> facts_;
};

}  // namespace warpjet::source
