#include "frame/frame.hpp"

#include <memory>

#include "frame/separation.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

// A copy of a module's graph with its frame constants separated, and the module's results in it.
struct SeparatedModule {
  SeparatedModule(Module& module, std::span<const std::uint32_t> known, bool unrolls)
      : graph(module.graph.copy()),
        roots(unrolls ? unrollFolds(graph, module.roots()) : module.roots()),
        separation(graph, module.library, known) {
    for (const NodeId id : reachable(graph, roots)) separation.visit(id);
    for (NodeId& root : roots) root = separation.replacementOf(root);
  }

  Graph graph;
  std::vector<NodeId> roots;
  Separation separation;
};

// Replaces values that no result reads by zero, so that they need not be computed.
void clearUnread(const Graph& graph, std::span<const NodeId> roots, std::uint32_t firstInput,
                 std::vector<NodeId>& values, NodeId zero) {
  Flags isRead(values.size());
  for (const NodeId id : reachable(graph, roots)) {
    if (!graph.isInput(id) || graph.node(id).operands[0] < firstInput) continue;
    isRead[(graph.node(id).operands[0] - firstInput) * 4 + graph.node(id).operands[1]] = true;
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!isRead[i]) values[i] = zero;
  }
}

}  // namespace

std::uint32_t separateFrame(Module& module, std::span<const std::uint32_t> known) {
  const auto firstInput = static_cast<std::uint32_t>(module.graph.inputCount());
  auto separated = std::make_unique<SeparatedModule>(module, known, false);
  if (canUnroll(module.graph)) {
    // Each step of a loop may add a different frame constant.
    auto unrolled = std::make_unique<SeparatedModule>(module, known, true);
    if (unrolled->separation.reduced() > separated->separation.reduced())
      separated = std::move(unrolled);
  }
  auto& [graph, roots, separation] = *separated;
  std::vector<NodeId> values = separation.inputs().values();
  const NodeId zero = graph.constant(0);
  clearUnread(graph, roots, firstInput, values, zero);
  if (graph.isFull() || values.empty()) return 0;
  values.resize(4 * separation.inputs().count(), zero);
  auto node = roots.begin();
  for (Output& output : module.outputs) {
    for (NodeId& component : output.components) component = *node++;
  }
  module.methods.resize(graph.inputCount());
  module.graph = std::move(graph);
  module.outputs.push_back({frameLabel, scalarShape, std::move(values)});
  return separation.inputs().count();
}

}  // namespace warpjet
