// A register program as WebAssembly of its own: what the interpreter of blocks.hpp does operation
// by operation, an engine makes machine code of, with values in registers. The bits are the same,
// since the same formulas are run; only what a NaN has in it WebAssembly leaves open.
//
// The module imports the memory, and the interpreter's own functions for what is longer than some
// instructions. Its functions have some hundred instructions each, with registers in memory between
// them: engines compile a long function slowly, and take their best compiler for what is called
// often.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eval/registers.hpp"

namespace warpjet {

// Where an array is, at an offset in the memory that a call is given: `size` floats a vertex, or,
// if it is uniform, for all. It has room for whole fours of vertices.
struct Placement {
  std::uint32_t offset, size;
  bool isUniform = false;
};

struct MachineCode {
  // Exports `start(memory, 0)`, which reads the uniform inputs, and `run(memory, end)`, for a
  // fourth of `end` vertices, a multiple of 16.
  std::vector<std::uint8_t> module;
  // Bits of floats that must be at this offset before `start`: the last that the memory must have.
  std::uint32_t sharedAt;
  std::vector<std::uint32_t> shared;
};

// What is above this, an engine would compile too long: then there is none.
inline constexpr std::size_t mostInstructions = 100'000;

// The inputs of a program in order, and its results, all of them before `end`.
MachineCode machineCode(const RegisterProgram& program, std::span<const Placement> inputs,
                        std::span<const Placement> results, std::uint32_t end);

}  // namespace warpjet
