#include <algorithm>

#include "graph/reachable.hpp"
#include "module/module.hpp"

namespace warpjet {

std::vector<std::uint32_t> inputsRead(const Module& module,
                                      std::span<const std::uint32_t> results) {
  std::vector<std::uint32_t> inputs;
  for (const NodeId id : reachable(module.graph, module.roots(results))) {
    const auto& [operands, op] = module.graph.node(id);
    if (op == inputOp) inputs.push_back(operands[0]);
  }
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  return inputs;
}

}  // namespace warpjet
