// The order of the statements: statements enter, their order of writing leaves.
#pragma once

#include <cstdint>
#include <vector>

#include "emit/statements.hpp"

namespace warpjet {

// Statement numbers, each after those that it reads: list scheduling that keeps few values alive.
// Of the statements that could be next, the one comes first with which the most values die, among
// equals the one from which the longest way leads to a result (after Goodman and Hsu, "Code
// Scheduling and Register Allocation in Large Basic Blocks", 1988). The ways of several results are
// thus walked side by side, which leaves a processor something to do while it waits.
//
// Tried, as frame times relative to "each derivative right after its value" (SwiftShader, medians
// within a round; the same text compiled again varies by up to 7%):
//
//                                 3 chains of 24 nested sines   600 stacked sines
//   in the order of the sketch                1.05                    0.96
//   by depth from the inputs                  0.69                    0.95, first draw 1.3
//   this, without maxReads                    0.68                    1.00
//   this, maxReads 3                          0.65                    0.96
//   this, maxReads 4                          0.67                    0.90
//   this, maxReads 6                          0.68                    0.94
//
// By the longest way alone, while few values are alive, was no better than the noise.
std::vector<std::uint32_t> schedule(const Statements& statements);

}  // namespace warpjet
