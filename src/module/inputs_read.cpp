#include <algorithm>

#include "graph/reachable.hpp"
#include "module/module.hpp"

namespace warpjet {

std::vector<std::uint32_t> inputsRead(const Module& module,
                                      std::span<const std::uint32_t> results) {
  std::vector<NodeId> roots;
  for (const std::uint32_t result : results) {
    const std::vector<NodeId>& components = module.outputs[result].components;
    roots.insert(roots.end(), components.begin(), components.end());
  }
  std::vector<std::uint32_t> inputs;
  for (const NodeId id : reachable(module.graph, roots)) {
    const auto& [operands, op] = module.graph.node(id);
    if (op == inputOp) inputs.push_back(operands[0]);
  }
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

}  // namespace warpjet
