// Loops that remain loops in the shader: the variables that their bodies change, and their number
// of iterations.
#pragma once

#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

#include "source/recorder.hpp"
#include "source/store.hpp"

namespace warpjet::source {

// The min number of operations that a loop must save to remain a loop. Short loops are shorter
// unrolled, since their constants fold, and their derivatives need no states. GLSL 3.00 with
// normals in SwiftShader on a busy machine, a loop next to its unrolled version, in characters and
// milliseconds of the first draw:
//
//   steps x operations     loop           unrolled
//   8 x 9                  1,561    42    1,234    27
//   3 x 18                 1,923    25    1,580    44
//   8 x 18                 1,923    24    4,041    72
//   5 octaves of snoise    9,055   135    8,442   983    (a function in both)
//
// Frames of 20,000 vertices take 29 to 34 ms and differ by less than the noise of these
// measurements.
inline constexpr std::size_t minSavedOperations = 100;

// The limits of the builder: the product of the iterations of nested loops, and their depth.
inline constexpr std::uint32_t maxFoldedSteps = 10'000;
inline constexpr std::size_t maxFoldDepth = 8;
// The limit for the states of a loop. Every element of an array that a loop fills is a state.
inline constexpr std::size_t maxStates = 32;
// The largest value of the option maxIterations. Equal to `maxIterationLimit` in iterations.ts.
inline constexpr int maxIterationLimit = 4096;

// Values of `maxIterations` other than a limit. `rejectUnknown` rejects loops whose end only the
// shader knows. With `untilEnd` they run until they end; a loop that can't stay a loop is cut off.
inline constexpr int rejectUnknown = 0, untilEnd = -1;

// A variable that the body of a loop changes.
struct Changing {
  Store::Slot slot;
  Id start;
  enum class Kind : std::uint8_t {
    Fixed,    // changes only within an iteration
    Counter,  // changes by the same integer in each step
    State,
  } kind = Kind::State;
  double by = 0;  // the change of a counter per step
  // True for an int or uint that does more than count. It has two states, since a state is a float,
  // which can't represent 32 bits: the remainder of a division by 2^16, and at the index `high` the
  // quotient, rounded towards 0.
  bool isWide = false;
  std::size_t high = 0;
  // The values of the variable: before a step (`now`); at the end of the step, if the loop
  // continues (`atEnd`); and after the step in any case, even if the loop ends early (`next`).
  Id now{}, atEnd{}, next{};
};

struct Folding {
  std::vector<Changing> all;
  // The number of steps; until it is known, the largest that a counted loop may have.
  std::uint32_t steps;
  Id test;
  // True if the condition is evaluated in each step, since the number of iterations is unknown.
  bool evaluatesTest;
  std::uint32_t loop;
  // The number of operations of the body.
  std::size_t size;

  bool isCounted() const { return steps != uncountedSteps; }
};

// Runs a loop as far as its values are known.
class LoopRun {
 public:
  LoopRun(const Recorder& recorder, std::uint32_t loop, const std::vector<Changing>& all)
      : recorder_(recorder), loop_(loop), all_(all) {
    for (const Changing& each : all) {
      const bool isKnown = recorder.isConstant(each.start);
      states_.push_back(isKnown ? std::optional(recorder.value(each.start)) : std::nullopt);
    }
    isQueried_.resize(all.size());
  }

  // Returns the value in the current step; nullopt if it is unknown or takes too long to compute.
  std::optional<double> value(Id id) {
    known_.clear();
    budget_ = maxVisits;
    return find(id, maxDepth);
  }

  void advance();

 private:
  static constexpr int maxVisits = 200, maxDepth = 50;

  std::optional<double> find(Id id, int depth);

  const Recorder& recorder_;
  std::uint32_t loop_;
  const std::vector<Changing>& all_;
  double step_ = 0;
  std::vector<std::optional<double>> states_;
  std::vector<bool> isQueried_;
  std::unordered_map<std::uint32_t, double> known_;
  int budget_ = maxVisits;
};

}  // namespace warpjet::source
