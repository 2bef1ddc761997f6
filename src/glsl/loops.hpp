// What becomes a loop of the shader: the variables that its body changes, and how often it runs.
#pragma once

#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

#include "glsl/recorder.hpp"
#include "glsl/store.hpp"

namespace warpjet::glsl {

// By how many operations less a loop is worth to be one. What is short is shorter unrolled, since
// its constants fold, and its derivatives need no states. GLSL 3.00 with normals in SwiftShader,
// the machine busy, a loop beside the same unrolled, in characters and milliseconds of the first
// draw:
//
//   steps x operations     loop           unrolled
//   8 x 9                  1,561    42    1,234    27
//   3 x 18                 1,923    25    1,580    44
//   8 x 18                 1,923    24    4,041    72
//   5 octaves of snoise    9,055   135    8,442   983    (a function in both)
//
// Frames of 20,000 vertices differ by less than the noise of these, 29 to 34 ms.
inline constexpr std::size_t worthwhile = 100;

// A variable that the body of a loop changes.
struct Changing {
  Store::Slot slot;
  Id start;
  enum class Kind : std::uint8_t {
    Fixed,    // within an iteration only
    Counter,  // by the same whole number each time
    State,
  } kind = Kind::State;
  double by = 0;
  // In a step: before it, where the next one would begin, and after it whatever ended it early.
  Id now{}, atEnd{}, next{};
};

struct Folding {
  std::vector<Changing> all;
  std::uint32_t steps;
  Id test;
  // Whether the condition is asked in each step, since nobody knows how often it holds.
  bool asks;
  std::uint32_t loop;
  // Of the body, in operations.
  std::size_t size;
};

// A loop as it runs, as far as its numbers are known.
class LoopRun {
 public:
  LoopRun(const Recorder& recorder, std::uint32_t loop, const std::vector<Changing>& all)
      : recorder_(recorder), loop_(loop), all_(all) {
    for (const Changing& each : all) {
      const bool isKnown = recorder.isConstant(each.start);
      states_.push_back(isKnown ? std::optional(recorder.value(each.start)) : std::nullopt);
    }
    isAsked_.resize(all.size());
  }

  // In this step; nothing of what is not known, or is long.
  std::optional<double> value(Id id) {
    known_.clear();
    budget_ = most;
    return find(id, deepest);
  }

  void advance();

 private:
  static constexpr int most = 200, deepest = 50;

  std::optional<double> find(Id id, int depth);

  const Recorder& recorder_;
  std::uint32_t loop_;
  const std::vector<Changing>& all_;
  double step_ = 0;
  std::vector<std::optional<double>> states_;
  std::vector<bool> isAsked_;
  std::unordered_map<std::uint32_t, double> known_;
  int budget_ = most;
};

}  // namespace warpjet::glsl
