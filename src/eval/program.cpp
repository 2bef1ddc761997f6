#include "eval/program.hpp"

#include "eval/words.hpp"
#include "graph/reachable.hpp"
#include "module/messages.hpp"

namespace warpjet {

namespace {

// Returns true if the node is an image or the size of one.
bool readsImage(const Graph& graph, NodeId id) {
  if (!graph.isInput(id)) return false;
  const Input& input = graph.input(graph.node(id).operands[0]);
  return input.shape == imageShape || input.image;
}

}  // namespace

std::optional<Program> program(const Graph& graph, std::span<const NodeId> roots) {
  // The index of each input's first number.
  std::vector<std::uint32_t> places;
  std::uint32_t place = 0;
  for (std::uint32_t input = 0; input < graph.inputCount(); ++input) {
    places.push_back(place);
    const Shape shape = graph.input(input).shape;
    place += shape == imageShape ? 0 : static_cast<std::uint32_t>(shape.size());
  }

  Program program;
  std::vector<std::uint32_t> instructionOf(graph.size());
  for (const NodeId id : reachable(graph, roots)) {
    if (graph.isCall(id) || graph.isFold(id)) return std::nullopt;
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

ModuleProgram program(const Module& module, std::span<const std::uint32_t> results) {
  const std::vector<NodeId> roots = module.roots(results);
  bool hasBodies = false;
  for (const NodeId id : reachable(module.graph, roots)) {
    if (readsImage(module.graph, id)) return {};
    hasBodies |= module.graph.isLibraryCall(id) || module.graph.isFold(id);
  }
  if (!hasBodies) return {program(module.graph, roots)};
  Graph graph = module.graph.copy();
  Library library = module.library.withEmptyCaches();
  const std::vector<NodeId> inlined = inlineCalls(graph, library, roots);
  if (graph.isFull() || library.isFull()) return {{}, "A result: " + std::string(tooLarge)};
  return {program(graph, inlined)};
}

bool reads(const Program& program, std::uint32_t first, std::uint32_t count) {
  const Words words(program.words, program.instructions);
  for (std::uint32_t i = 0; i < words.count(); ++i) {
    if (words.op(i) == inputOp && words.input(i) - first < count) return true;
  }
  return false;
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
      Operands<double> operands{};
      auto value = operands.begin();
      for (const std::uint32_t operand : program.operands(i)) *value++ = values[operand];
      values[i] = ops::valueOf(op, operands);
    }
  }
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = values[program.result(i)];
}

}  // namespace warpjet
