// What is asked for in the end: results by name, and the results of a warp.
#include <algorithm>
#include <utility>
#include <vector>

#include "builder/builder.hpp"
#include "graph/reachable.hpp"
#include "module/sentences.hpp"
#include "warp/warp.hpp"

namespace warpjet {

void Builder::output(std::string_view method, std::string_view name, int handle) {
  addOutput(method, name, values_.get(graph_, handle));
}

void Builder::addOutput(std::string_view method, std::string_view name, const Value& value) {
  const auto nodes = value.nodes();
  module_.outputs.push_back(
      {std::string(name), value.shape(), {nodes.begin(), nodes.end()}, std::string(method)});
}

int Builder::warp(std::string_view method, const WarpOptions& options) {
  const std::size_t before = graph_.size();
  // A condition becomes 0 or 1 here, as it does in any sum.
  const Value offset = operands_[0] + constantLike(operands_[0], 0);
  if (options.turns && !hasAllPartials(offset)) {
    operands_.clear();
    return needsPartials;
  }
  const WarpInputs inputs{operands_[1],
                          operands_[2],
                          operands_[3],
                          operands_[4],
                          {operands_[5], operands_[6], operands_[7], operands_[8], operands_[9]}};
  const Warp warp = makeWarp(differentiator_, offset, inputs, options);

  std::vector<std::pair<std::string_view, Value>> results{{"offset", warp.offset},
                                                          {"position", warp.position}};
  const auto addTurned = [&](const Turned& turned) {
    results.insert(results.end(), {{"normal", turned.normal},
                                   {"tangent", turned.tangent},
                                   {"direction", turned.direction},
                                   {"determinant", turned.determinant}});
  };
  if (warp.surface) {
    addTurned(warp.flat ? *warp.flat : *warp.surface);
    addTurned(*warp.surface);
  }
  std::vector<NodeId> nodes;
  for (const auto& [name, value] : results)
    nodes.insert(nodes.end(), value.nodes().begin(), value.nodes().end());
  operands_.clear();
  if (!isPossible(nodes, before, method)) return failed;
  for (const auto& [name, value] : results) addOutput(method, name, value);
  return warp.varies;
}

bool Builder::finish() {
  problem_.clear();
  // Every value was searched when it was made; but a sketch may catch a problem and go on.
  if (wasImpossible_) {
    for (const NodeId id : reachable(graph_, module_.roots())) {
      if (const auto* why = impossible(id)) refuse("A result", {*why});
    }
  }
  if (graph_.full()) refuse("A result", {tooLarge});
  return problem_.empty();
}

}  // namespace warpjet
