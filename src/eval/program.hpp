// Evaluation on the CPU in double precision: compiles roots of a graph to a program of plain words,
// which is independent of the graph and of the wasm instance that made it; the program maps numbers
// to numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graph/graph.hpp"
#include "module/module.hpp"

namespace warpjet {

// One instruction per node, operands first: its operation, then its operands, which are earlier
// instructions, or the bits of a constant, or the index of an input number. After that, the
// instructions of the results. words.hpp reads them.
struct Program {
  std::vector<std::uint32_t> words;
  std::uint32_t instructions = 0;
};

// Compiles the roots. The program's input numbers (floats) are the components of all inputs of the
// graph except images, in order. Returns nullopt if it would have to call a host function or to run
// a loop.
std::optional<Program> program(const Graph& graph, std::span<const NodeId> roots);

// The program of these results of a module, in this order, with the bodies of our functions inlined
// and folds unrolled. There is no program if the results need a host function or an image, or if
// they are too many operations, which sets `problem`.
struct ModuleProgram {
  std::optional<Program> program;
  std::string problem = {};
};
ModuleProgram program(const Module& module, std::span<const std::uint32_t> results);

// Returns true if the program reads any of `count` input numbers starting at `first`.
bool reads(const Program& program, std::uint32_t first, std::uint32_t count);

// Runs a program, given its words and the number of its instructions. Conditions are 1 and 0.
void evaluate(std::span<const std::uint32_t> words, std::uint32_t instructions,
              std::span<const double> inputs, std::span<double> results);

}  // namespace warpjet
