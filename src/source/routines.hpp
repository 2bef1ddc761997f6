// Functions of the source that remain functions: recorded once, from numbers to numbers, for all
// their calls.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "source/recorder.hpp"

namespace warpjet::source {

// The function's number, and its arguments: arguments that aren't floats are known, and are
// represented by their value.
using RoutineKey = std::vector<double>;

struct Routine {
  RoutineKey key;
  std::string name;
  // The number of its parameters in the recorder.
  std::uint32_t number;
  std::size_t parameters;
  // Values that it reads from outside; calls pass them after the arguments.
  std::vector<Id> outside;
  std::vector<Id> results;
};

// The max number of arguments, and of results.
inline constexpr std::size_t maxNumbers = 16;

// The min number of operations per result: for shorter bodies, the call and the derivatives with
// respect to each argument would be longer than the body.
inline constexpr std::size_t minOperationsPerResult = 12;

// Returns the routines that are called from a single place: these are inlined, which is shorter.
std::set<RoutineKey> calledOnce(const Recorder& recorder, const std::vector<Routine>& routines,
                                const std::vector<Id>& results);

}  // namespace warpjet::source
