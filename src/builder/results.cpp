// What is asked for in the end: results by name, and the results of a warp.
#include <algorithm>

#include "builder/builder.hpp"
#include "graph/reachable.hpp"
#include "module/sentences.hpp"
#include "warp/warp.hpp"

namespace warpjet {

void Builder::output(std::string_view method, std::string_view name, int handle) {
  const Value value = values_.get(graph_, handle);
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

  bool isFine = true;
  const auto ask = [&](std::string_view name, const Value& value) {
    const int handle = finish(value, before, method);
    isFine &= handle != failed;
    if (isFine) output(method, name, handle);
  };
  const auto askTurned = [&](const Turned& turned) {
    ask("normal", turned.normal);
    ask("tangent", turned.tangent);
    ask("direction", turned.direction);
    ask("determinant", turned.determinant);
  };
  ask("offset", warp.offset);
  ask("position", warp.position);
  if (warp.surface) {
    askTurned(warp.flat ? *warp.flat : *warp.surface);
    askTurned(*warp.surface);
  }
  return isFine ? warp.varies : failed;
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
