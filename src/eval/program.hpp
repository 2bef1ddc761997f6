// Evaluation on the CPU, in double: roots of a graph become a program of plain words, which needs
// neither the graph nor the wasm that it came from; a program and numbers give numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "graph/graph.hpp"
#include "module/module.hpp"

namespace warpjet {

// One instruction for each node, operands first: its operation, then its operands, which are
// earlier instructions, or the bits of a constant, or the place of an input among the numbers. Then
// the instructions that give the results. words.hpp reads them.
struct Program {
  std::vector<std::uint32_t> words;
  std::uint32_t instructions = 0;
};

// Numbers are given to the program for all inputs of the graph but images in order, component by
// component.
// Nothing if the program would have to call a function of the host, or to run a loop.
std::optional<Program> program(const Graph& graph, std::span<const NodeId> roots);

// Of these results of a module, in this order, with the bodies of our functions in it, and those of
// folds as often as they are run. Nothing if a
// function or an image of the host is needed for them, or, which is a problem, if they are too many
// operations.
struct ModuleProgram {
  std::optional<Program> program;
  std::string problem = {};
};
ModuleProgram program(const Module& module, std::span<const std::uint32_t> results);

// Tells whether the program reads any of `count` input numbers from `first` on.
bool reads(const Program& program, std::uint32_t first, std::uint32_t count);

// Runs a program of so many instructions; conditions are 1 and 0.
void evaluate(std::span<const std::uint32_t> words, std::uint32_t instructions,
              std::span<const double> inputs, std::span<double> results);

}  // namespace warpjet
