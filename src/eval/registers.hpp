// Allocates registers for evaluation in blocks: takes a program, returns the instructions that the
// wanted results need, in an order that keeps few values alive. Registers are reused after the last
// use of their value.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// A register: one value per vertex of a block, or one for all.
struct Register {
  std::uint32_t number = 0;
  bool isUniform = true;
};

// An operation on registers; or, if it is `inputOp`, the input number to load into a register.
struct RegisterInstruction {
  Op op{};
  Register result;
  Operands<Register> operands{};
  std::uint32_t input = 0;
};

struct RegisterProgram {
  // Constants are stored in the first uniform registers; `prologue` computes the others once,
  // before all blocks.
  std::vector<float> constants;
  std::vector<RegisterInstruction> prologue, body;
  std::vector<Register> results;
  std::uint32_t uniformRegisters = 0, blockRegisters = 0;
};

// Takes the words and instruction count of a `Program`, and the numbers of its `wanted` results.
// `isUniform` says for each input number whether it is the same for all vertices.
RegisterProgram allocateRegisters(std::span<const std::uint32_t> words, std::uint32_t instructions,
                                  std::span<const std::uint32_t> wanted,
                                  const std::vector<bool>& isUniform);

}  // namespace warpjet
