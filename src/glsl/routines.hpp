// Functions of a text that stay functions: recorded once, from numbers to numbers, however often
// they are called.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "glsl/recorder.hpp"

namespace warpjet::glsl {

// The function's number, and its arguments: what is no float is known, and has its value here.
using RoutineKey = std::vector<double>;

struct Routine {
  RoutineKey key;
  std::string name;
  // What its parameters are numbered by in the recorder.
  std::uint32_t number;
  std::size_t parameters;
  // What it reads from outside, which calls hand it after its arguments.
  std::vector<Id> outside;
  std::vector<Id> results;
};

// What calls take, and give.
inline constexpr std::size_t mostNumbers = 16;

// In operations for each number that it gives: of what is shorter, the call and the derivatives by
// each argument would be longer than the body.
inline constexpr std::size_t shortest = 12;

// Those that only one place calls: there they are entered, which is shorter.
std::set<RoutineKey> calledOnce(const Recorder& recorder, const std::vector<Routine>& routines,
                                const std::vector<Id>& results);

}  // namespace warpjet::glsl
