// Bounds of a program's results: takes ranges of its inputs, returns ranges that contain every
// result.
//
// Uses interval arithmetic, which is never too narrow, but far too wide where a value occurs twice,
// as in p + (rotate(p) - p). So the ranges of the inputs are split where the bound is worst, until
// it is close to the values at sampled points (branch and bound: R. E. Moore, R. B. Kearfott, M. J.
// Cloud, "Introduction to Interval Analysis", 2009, section 10). The same input gives the same
// bounds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace warpjet {

// Empty if `low` > `high`.
struct Range {
  double low, high;
};

struct BoundsOptions {
  // The max distance of each bound from an actual value, as a share of the range of values.
  double tolerance = 0.02;
  // The approximate number of instructions that may be run. Plain interval arithmetic is always
  // done.
  std::uint64_t budget = 4'000'000;
};

// Returns for each of the `wanted` results, by number, a range that contains all its values for
// inputs in their ranges. The range also contains the float32 results of the CPU, and of a GPU
// whose functions are as accurate: see ops/interval.hpp, and `float32Slack`. A less accurate sine
// may exceed the range by its error times the amplitude. Points where the result is NaN, like the
// root of a negative number, are excluded. An input may be infinite or NaN. No input's range may be
// empty: the caller has to check.
std::vector<Range> bounds(std::span<const std::uint32_t> words, std::uint32_t instructions,
                          std::span<const Range> inputs, std::span<const std::uint32_t> wanted,
                          const BoundsOptions& options = {});

// The share of the max magnitude by which a range is finally widened: shaders have sin, cos and log
// with absolute errors of about 2^-20 near their zeros.
inline constexpr double float32Slack = 1e-5;

}  // namespace warpjet
