// Compiles a register program to WebAssembly, which an engine compiles to machine code with values
// in registers. The results have the same bits as those of the interpreter, blocks.hpp, since the
// same formulas are evaluated; WebAssembly only leaves the payload of NaN open.
//
// The module imports the memory, and the interpreter's own functions for operations that are longer
// than a few instructions. Its functions have a few hundred instructions each, and pass registers
// to each other in memory: engines compile long functions slowly, and use their optimizing compiler
// for functions that are called often.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "eval/registers.hpp"

namespace warpjet {

// The location of an array, at an offset in the memory passed to a call: `size` floats per vertex,
// or in total if it is uniform. It is padded to a multiple of four vertices.
struct Placement {
  std::uint32_t offset, size;
  bool isUniform = false;
};

struct MachineCode {
  // Exports `start(memory, 0)`, which reads the uniform inputs, and `run(memory, end)` for `end` /
  // 4 vertices, where `end` is a multiple of 16.
  std::vector<std::uint8_t> module;
  // The bits of floats that must be stored at the offset `sharedAt` before `start` is called. They
  // are the last part of the memory.
  std::uint32_t sharedAt;
  std::vector<std::uint32_t> shared;
};

// Larger programs would take an engine too long to compile, so there is no machine code for them.
inline constexpr std::size_t maxInstructions = 100'000;

// Compiles the program. `inputs` and `results` are in the program's order; all arrays are located
// before `end`.
MachineCode machineCode(const RegisterProgram& program, std::span<const Placement> inputs,
                        std::span<const Placement> results, std::uint32_t end);

}  // namespace warpjet
