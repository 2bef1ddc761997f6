#include "eval/cost.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "graph/folds.hpp"
#include "graph/multi_index.hpp"
#include "graph/reachable.hpp"
#include "noise/noise.hpp"

namespace warpjet {

namespace {

// A function without a body reads an image or is the host's own: four reads with their addresses.
constexpr double costWithoutBody = 20;

class Counter {
 public:
  explicit Counter(const Library& library) : library_(library.withEmptyCaches()) {}

  Cost cost(const Graph& graph, std::span<const NodeId> roots) {
    const double operations = count(graph, roots);
    return {operations, hasNoise_, needsGpu_};
  }

 private:
  double count(const Graph& graph, std::span<const NodeId> roots) {
    const std::vector<NodeId> nodes = reachable(graph, roots);
    const std::map<NodeId, int> orders = ordersOfCalls(graph, nodes);
    const Loops loops(graph, nodes);
    double sum = 0;
    for (const NodeId id : loops.order())
      sum += stepsOf(graph, loops, loops.loopOf(id)) * costOfNode(graph, id, orders);
    return sum;
  }

  // Maps a call of our functions → the highest order of its derivatives that is read.
  static std::map<NodeId, int> ordersOfCalls(const Graph& graph, std::span<const NodeId> nodes) {
    std::map<NodeId, int> orders;
    for (const NodeId id : nodes) {
      if (!graph.isResult(id)) continue;
      const NodeId call = graph.operand(id, 0);
      const Function& function = graph.function(call);
      const int number = static_cast<int>(graph.node(id).operands[1]) / function.values;
      int& order = orders[call];
      order = std::max(order, MultiIndices::orderOf(function.variables, number));
    }
    return orders;
  }

  // Returns how often the body of a loop runs, including all loops around it.
  static double stepsOf(const Graph& graph, const Loops& loops, std::uint32_t loop) {
    double steps = 1;
    for (; loop != Loops::outside; loop = loops.parentOf(loop))
      steps *= graph.loop(loop).estimatedSteps();
    return steps;
  }

  double costOfNode(const Graph& graph, NodeId id, const std::map<NodeId, int>& orders) {
    if (graph.isLibraryCall(id)) return costOfCall(graph.function(id).name, orders.at(id));
    if (graph.isCall(id)) {
      needsGpu_ = true;
      return costWithoutBody;
    }
    if (graph.isInput(id)) needsGpu_ |= graph.input(graph.node(id).operands[0]).image.has_value();
    return index(graph.node(id).op) < ops::count ? 1 : 0;
  }

  double costOfCall(const std::string& name, int order) {
    const auto [known, isNew] = known_.try_emplace({name, order}, costWithoutBody);
    const Definition& definition = library_.definition(name);
    hasNoise_ |= definition.maker == noiseFrom;
    needsGpu_ |= !definition.hasBody() || definition.parameters == Definition::imageParameters;
    if (!isNew || !definition.hasBody()) return known->second;
    const int results =
        definition.function.values * MultiIndices::countUpTo(definition.function.variables, order);
    const Body& body = library_.withResults(name, order);
    return known->second = count(body.graph, std::span(body.results).first(results));
  }

  Library library_;
  std::map<std::pair<std::string, int>, double> known_;  // by function and order of derivatives
  bool hasNoise_ = false, needsGpu_ = false;
};

}  // namespace

Cost costOf(const Module& module, std::span<const std::uint32_t> results) {
  return Counter(module.library).cost(module.graph, module.roots(results));
}

}  // namespace warpjet
