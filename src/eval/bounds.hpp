// Bounds of a program's results: ranges of its inputs enter, ranges that hold every result leave.
//
// By interval arithmetic, which is never too small but far too wide where a value occurs twice, as
// in p + (turned(p) - p). So the ranges of the inputs are split where the bound is worst, until it
// is near the values at sampled points (branch and bound: R. E. Moore, R. B. Kearfott, M. J. Cloud,
// "Introduction to Interval Analysis", 2009, section 10). The same input gives the same bounds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace warpjet {

// Without any value, `low` is above `high`.
struct Range {
  double low, high;
};

struct BoundsOptions {
  // How far each bound may be from a value, as a share of the distance between all values.
  double tolerance = 0.02;
  // How many instructions may be run, about. Plain interval arithmetic is done in any case.
  std::uint64_t budget = 4'000'000;
};

// For each of the `wanted` results, by number, a range that holds all its values where each input
// is in its range. It also holds what float32 gives on the CPU, and on a GPU whose functions are as
// accurate: see ops/interval.hpp, and `float32Slack`. One whose sine is off by more goes beyond by
// as much, times the amplitude. Points where the result is not a number, like the root of a
// negative one, are left out. An input may be infinite or not a number. No input's range is empty:
// that is the caller's error.
std::vector<Range> bounds(std::span<const std::uint32_t> words, std::uint32_t instructions,
                          std::span<const Range> inputs, std::span<const std::uint32_t> wanted,
                          const BoundsOptions& options = {});

// The share of the greatest absolute value by which a range is widened at the end: shaders have
// sin, cos and log with absolute errors of about 2^-20 near their zeros.
inline constexpr double float32Slack = 1e-5;

}  // namespace warpjet
