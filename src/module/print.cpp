#include "module/print.hpp"

#include "graph/print.hpp"

namespace warpjet {

std::string print(const Module& module) {
  std::string all = print(module.graph, module.roots());
  for (const Output& output : module.outputs) {
    std::string components;
    for (const NodeId id : output.components)
      components += (components.empty() ? "" : ", ") + nameOf(module.graph, id);
    all += output.name + ": " + components + "\n";
  }
  return all;
}

}  // namespace warpjet
