// Code that is recorded once and runs repeatedly: the body of `repeat`, and functions.
#include <algorithm>
#include <utility>

#include "builder/builder.hpp"
#include "graph/reachable.hpp"
#include "module/messages.hpp"

namespace warpjet {

namespace {

constexpr std::string_view repeatMethod = "repeat";

}  // namespace

int Builder::openRepeat(int steps) {
  const std::vector<Value> start = std::exchange(operands_, {});
  const bool isCounted = steps != uncounted;
  std::uint64_t totalSteps = isCounted ? static_cast<std::uint64_t>(steps) : 1;
  for (const Repeat& repeat : repeats_) {
    const Loop& loop = graph_.loop(repeat.fold.loop);
    if (loop.isCounted()) totalSteps *= std::max(loop.steps, 1u);
  }
  if (totalSteps > maxSteps) {
    reject(repeatMethod, {"expected at most ", std::to_string(maxSteps),
                          " steps, where those of nested repeats are multiplied, got ",
                          std::to_string(totalSteps), "."});
    return failed;
  }
  if (repeats_.size() == maxLoopDepth) {
    reject(repeatMethod,
           {"repeats can be nested at most ", std::to_string(maxLoopDepth), " deep."});
    return failed;
  }
  Repeat repeat;
  std::vector<NodeId> nodes;
  for (const Value& value : start) {
    repeat.shapes.push_back(value.shape());
    nodes.insert(nodes.end(), value.nodes().begin(), value.nodes().end());
  }
  repeat.fold =
      openFold(graph_, isCounted ? static_cast<std::uint32_t>(steps) : uncountedSteps, nodes);
  const int step = values_.add(repeat.fold.step);
  addAll(repeat.shapes, repeat.fold.states);
  repeats_.push_back(std::move(repeat));
  return step;
}

int Builder::closeRepeat() {
  const std::vector<Value> next = std::exchange(operands_, {});
  const Repeat repeat = std::move(repeats_.back());
  repeats_.pop_back();
  std::vector<NodeId> nodes;
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (next[i].shape() != repeat.shapes[i]) {
      reject(repeatMethod,
             {"expected ", shapeName(repeat.shapes[i]), " as the next value of state ",
              std::to_string(i + 1), ", got ", shapeName(next[i].shape()), "."});
      return failed;
    }
    nodes.insert(nodes.end(), next[i].nodes().begin(), next[i].nodes().end());
  }
  const std::vector<NodeId> outcomes = closeFold(graph_, repeat.fold, nodes);
  if (!checkPossible(outcomes, graph_.size(), repeatMethod)) return failed;
  return addAll(repeat.shapes, outcomes);
}

int Builder::addRecorded(std::string_view name, std::uint32_t variables,
                         std::span<const std::uint32_t> words) {
  if (const auto known = graph_.findFunction(name)) return static_cast<int>(*known);
  const Definition definition =
      readRecordedFunction(name, variables, {words.begin(), words.end()}, module_.library);
  module_.library.add(definition);
  return static_cast<int>(graph_.addFunction(definition.function));
}

int Builder::callRecorded(int function) {
  const std::string& name = graph_.function(static_cast<std::uint32_t>(function)).name;
  Numbers arguments;
  for (const Value& value : std::exchange(operands_, {})) arguments.push_back(value[0]);
  const Numbers values = module_.library.call(module_.library.definition(name), arguments);
  int first = failed;
  for (const Expression value : values) {
    const int handle = values_.add(value);
    if (first == failed) first = handle;
  }
  return first;
}

int Builder::addAll(std::span<const Shape> shapes, std::span<const NodeId> nodes) {
  int first = failed;
  for (const Shape shape : shapes) {
    const int handle = values_.add(fill(graph_, shape, [&](int i) {
      return Expression{&graph_, nodes[i]};
    }));
    if (first == failed) first = handle;
    nodes = nodes.subspan(static_cast<std::size_t>(shape.size()));
  }
  return first;
}

bool Builder::readsOpenRepeat(std::span<const NodeId> nodes, bool mayReadStep) {
  if (!graph_.has(localOp)) return false;
  const std::vector<NodeId> needed = reachable(graph_, nodes);
  const Loops loops(graph_, needed);
  for (const NodeId node : nodes) {
    if (loops.loopOf(node) == Loops::outside) continue;
    if (!mayReadStep) return true;
    for (const NodeId id : needed) {
      const bool isState = graph_.isLocal(id) && !graph_.isStep(id);
      if (isState && loops.reads(node, graph_.loopOf(id))) return true;
    }
  }
  return false;
}

bool Builder::checkReadsNoRepeat(const Value& value, std::string_view method) {
  if (!readsOpenRepeat(value.nodes(), false)) return true;
  reject(method, {onlyInItsBody});
  return false;
}

}  // namespace warpjet
