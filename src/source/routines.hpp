// Routines: functions of the source that remain functions in the shader. Their bodies are recorded
// once for all calls, in terms of numbers.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "source/recorder.hpp"

namespace warpjet::source {

// Identifies a routine: the number of the function, followed by the values of those arguments that
// aren't floats, which must be known.
using RoutineKey = std::vector<double>;

struct Routine {
  RoutineKey key;
  std::string name;
  // The number under which the recorder has its parameters.
  std::uint32_t number;
  std::size_t parameters;
  // Values that the routine reads from outside; calls pass them after the arguments.
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
