// From a program to one in registers, for evaluation by blocks: only what the wanted results need,
// in an order that keeps few values alive, each value in a register that is free again after its
// last use.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "graph/graph.hpp"

namespace warpjet {

// A register: one value for each vertex of a block, or one for all.
struct Register {
  std::uint32_t number = 0;
  bool isUniform = true;
};

// An operation on registers; or, if it is `inputOp`, the input of that place, read into a register.
struct RegisterInstruction {
  Op op{};
  Register result;
  Operands<Register> operands{};
  std::uint32_t input = 0;
};

struct RegisterProgram {
  // The first uniform registers hold these, the others what `prologue` makes once, before all
  // blocks.
  std::vector<float> constants;
  std::vector<RegisterInstruction> prologue, body;
  std::vector<Register> results;
  std::uint32_t uniformRegisters = 0, blockRegisters = 0;
};

// For the words and instructions of a `Program`: those of its results that are `wanted`, by number.
// `isUniform` says of each place of an input whether it is the same for all vertices.
RegisterProgram allocateRegisters(std::span<const std::uint32_t> words, std::uint32_t instructions,
                                  std::span<const std::uint32_t> wanted,
                                  const std::vector<bool>& isUniform);

}  // namespace warpjet
