#include "eval/program.hpp"

#include "eval/words.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

std::optional<Program> program(const Graph& graph, std::span<const NodeId> roots) {
  // Of each input, its first number.
  std::vector<std::uint32_t> places;
  std::uint32_t place = 0;
  for (std::uint32_t input = 0; input < graph.inputCount(); ++input) {
    places.push_back(place);
    place += static_cast<std::uint32_t>(graph.input(input).shape.size());
  }

  Program program;
  std::vector<std::uint32_t> instructionOf(graph.size());
  for (const NodeId id : reachable(graph, roots)) {
    if (graph.isCall(id)) return std::nullopt;
    auto [operands, op] = graph.node(id);
    if (graph.isInput(id)) operands[0] = places[operands[0]] + operands[1];
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
  const Words program(words, instructions);
  std::vector<double> values(instructions);
  for (std::uint32_t i = 0; i < instructions; ++i) {
    const Op op = program.op(i);
    if (op == constantOp) {
      values[i] = program.constant(i);
    } else if (op == inputOp) {
      values[i] = inputs[program.input(i)];
    } else {
      std::array<double, ops::maxArity> operands{};
      auto value = operands.begin();
      for (const std::uint32_t operand : program.operands(i)) *value++ = values[operand];
      values[i] = ops::evaluate(op, operands);
    }
  }
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = values[program.result(i)];
}

}  // namespace warpjet
