// The requested results: results by name, and the results of a warp.
#include <array>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "builder/builder.hpp"
#include "graph/reachable.hpp"
#include "module/messages.hpp"
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
  // Adding 0 converts a condition to 0 or 1.
  const Value offset = operands_[0] + constantLike(operands_[0], 0);
  if (!checkReadsNoRepeat(offset, method)) {
    operands_.clear();
    return failed;
  }
  if (options.needsDirections && !hasAllPartials(offset)) {
    operands_.clear();
    return needsPartials;
  }
  const Value* const in = &operands_[1];  // `warpOperands`
  const WarpInputs inputs{in[0], in[1], in[2], in[3], {in[4], in[5], in[6], in[7], in[8]}, in[9]};
  const Warp warp = makeWarp(differentiator_, offset, inputs, options);
  commentDerivatives();

  std::vector<std::pair<std::string_view, Value>> results;
  const auto add = [&](std::span<const std::string_view> names, std::span<const Value> values) {
    for (std::size_t i = 0; i < names.size(); ++i) results.emplace_back(names[i], values[i]);
  };
  const auto addDirections = [&](const WarpedDirections& warped) {
    add(orientedResults, std::array<Value, orientedResults.size()>{
                             warped.normal, warped.tangent, warped.direction, warped.determinant});
  };
  add(movedResults, std::array<Value, movedResults.size()>{warp.offset, warp.position});
  if (warp.surface) {
    results.emplace_back(orientationResult, *warp.orientation);
    addDirections(warp.flat ? *warp.flat : *warp.surface);
    addDirections(*warp.surface);
  }
  std::vector<NodeId> nodes;
  for (const auto& [name, value] : results)
    nodes.insert(nodes.end(), value.nodes().begin(), value.nodes().end());
  operands_.clear();
  if (!checkPossible(nodes, before, method)) return failed;
  for (const auto& [name, value] : results) addOutput(method, name, value);
  return warp.varies;
}

bool Builder::finish() {
  problem_.clear();
  // Every value was checked when it was made, but a sketch may catch an error and continue.
  if (wasImpossible_) {
    for (const NodeId id : reachable(graph_, module_.roots())) {
      if (const auto* why = explainImpossible(id)) reject("A result", {*why});
    }
  }
  if (readsOpenRepeat(module_.roots(), false)) reject("A result", {onlyInItsBody});
  if (graph_.isFull()) reject("A result", {tooLarge});
  return problem_.empty();
}

}  // namespace warpjet
