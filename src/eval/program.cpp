#include "eval/program.hpp"

#include <cstring>

#include "graph/reachable.hpp"

namespace warpjet {

namespace {

constexpr std::size_t wordsPerInstruction = 4;

// Of an input that the program is not given.
constexpr std::uint32_t nowhere = ~std::uint32_t{0};

}  // namespace

std::optional<Program> program(const Graph& graph, std::span<const std::uint32_t> inputs,
                               std::span<const NodeId> roots) {
  std::vector<std::uint32_t> places(graph.inputCount(), nowhere);
  std::uint32_t place = 0;
  for (const std::uint32_t input : inputs) {
    places[input] = place;
    place += static_cast<std::uint32_t>(graph.input(input).shape.size());
  }

  Program program;
  std::vector<std::uint32_t> instructionOf(graph.size());
  for (const NodeId id : reachable(graph, roots)) {
    if (graph.isCall(id)) return std::nullopt;
    auto [operands, op] = graph.node(id);
    if (graph.isInput(id) && places[operands[0]] == nowhere) {
      op = constantOp;
      operands = {};
    } else if (graph.isInput(id)) {
      operands[0] = places[operands[0]] + operands[1];
    }
    for (int i = 0; i < graph.arity(id); ++i) operands[i] = instructionOf[operands[i]];
    program.words.push_back(static_cast<std::uint32_t>(index(op)));
    program.words.insert(program.words.end(), operands.begin(), operands.end());
    instructionOf[index(id)] = program.instructions++;
  }
  for (const NodeId root : roots) program.words.push_back(instructionOf[index(root)]);
  return program;
}

void evaluate(std::span<const std::uint32_t> words, std::uint32_t instructions,
              std::span<const double> inputs, std::span<double> results) {
  std::vector<double> values(instructions);
  for (std::size_t i = 0; i < instructions; ++i) {
    const auto instruction = words.subspan(i * wordsPerInstruction, wordsPerInstruction);
    const Op op{static_cast<std::uint8_t>(instruction[0])};
    if (op == constantOp) {
      std::memcpy(&values[i], &instruction[1], sizeof(double));
    } else if (op == inputOp) {
      values[i] = inputs[instruction[1]];
    } else {
      std::array<double, ops::maxArity> operands{};
      for (int k = 0; k < arities[index(op)]; ++k) operands[k] = values[instruction[1 + k]];
      values[i] = ops::evaluate(op, operands);
    }
  }
  for (std::size_t i = 0; i < results.size(); ++i)
    results[i] = values[words[instructions * wordsPerInstruction + i]];
}

}  // namespace warpjet
