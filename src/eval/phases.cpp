#include "eval/phases.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include "graph/reachable.hpp"
#include "noise/noise.hpp"

namespace warpjet {

namespace {

// The step of a noise, as a share of the wavelength of its second octave; later octaves add little.
constexpr double stepOfNoise = 0.36;
constexpr int octavesOfNoise = 2;

// Operations with crests or kinks at regular distances.
struct Wave {
  Op op;
  double step;
};
constexpr Wave waves[]{{ops::find("sin"), std::numbers::pi},
                       {ops::find("cos"), std::numbers::pi},
                       {ops::find("tan"), std::numbers::pi / 2},
                       {ops::find("fract"), 0.5}};

std::optional<double> stepOfWave(Op op) {
  const auto found = std::find_if(std::begin(waves), std::end(waves),
                                  [op](const Wave& wave) { return wave.op == op; });
  return found == std::end(waves) ? std::nullopt : std::optional(found->step);
}

// Determines how nodes depend on inputs. Nodes are added in ascending order.
class Dependence {
 public:
  Dependence(const Graph& graph, std::span<const std::uint32_t> varying)
      : graph_(graph), varying_(varying), kinds_(graph.size()) {}

  void add(NodeId id) { kinds_[index(id)] = kindOf(id); }

  bool isVarying(NodeId id) const { return kinds_[index(id)] == Kind::Varying; }
  bool isInLoop(NodeId id) const { return kinds_[index(id)] == Kind::InLoop; }

 private:
  enum class Kind : std::uint8_t { Constant, Varying, InLoop };

  Kind kindOf(NodeId id) const {
    if (graph_.isLocal(id)) return Kind::InLoop;
    if (graph_.isInput(id)) {
      const std::uint32_t input = graph_.node(id).operands[0];
      return std::find(varying_.begin(), varying_.end(), input) == varying_.end() ? Kind::Constant
                                                                                  : Kind::Varying;
    }
    Kind kind = Kind::Constant;
    for (int i = 0; i < graph_.arity(id); ++i)
      kind = std::max(kind, kinds_[index(graph_.operand(id, i))]);
    // A step function, such as floor, is constant but for its jumps.
    const bool isStep = graph_.isOperation(id) && ops::isStep(graph_.node(id).op);
    return isStep && kind == Kind::Varying ? Kind::Constant : kind;
  }

  const Graph& graph_;
  std::span<const std::uint32_t> varying_;
  std::vector<Kind> kinds_;
};

// Returns the point at which a node evaluates a wave or a noise; empty for other nodes.
std::vector<NodeId> pointOf(const Module& module, NodeId id) {
  const Graph& graph = module.graph;
  if (stepOfWave(graph.node(id).op)) return {graph.operand(id, 0)};
  if (!graph.isLibraryCall(id)) return {};
  const Function& function = graph.function(id);
  if (module.library.definition(function.name).maker != noiseFrom) return {};
  std::vector<NodeId> point = graph.arguments(id);
  point.resize(function.variables);
  return point;
}

double stepOfCall(const Module& module, NodeId id) {
  const Definition& noise = module.library.definition(module.graph.function(id).name);
  return stepOfNoise * wavelengthOf(noise, octavesOfNoise - 1);
}

}  // namespace

std::vector<Phase> addPhases(Module& module, std::span<const std::uint32_t> results,
                             std::span<const std::uint32_t> varying) {
  const Graph& graph = module.graph;
  Dependence dependence(graph, varying);
  std::map<std::vector<NodeId>, double> steps;
  for (const NodeId id : reachable(graph, module.roots(results))) {
    dependence.add(id);
    const std::vector<NodeId> point = pointOf(module, id);
    const auto isVarying = [&](NodeId each) { return dependence.isVarying(each); };
    const auto isInLoop = [&](NodeId each) { return dependence.isInLoop(each); };
    if (std::none_of(point.begin(), point.end(), isVarying) ||
        std::any_of(point.begin(), point.end(), isInLoop))
      continue;
    const double step =
        graph.isLibraryCall(id) ? stepOfCall(module, id) : *stepOfWave(graph.node(id).op);
    const auto [found, isNew] = steps.try_emplace(point, step);
    if (!isNew) found->second = std::min(found->second, step);
  }
  std::vector<Phase> phases;
  Output output{.name = "phases", .shape = {}, .components = {}};
  for (const auto& [point, step] : steps) {
    phases.push_back({static_cast<std::uint32_t>(point.size()), step});
    output.components.insert(output.components.end(), point.begin(), point.end());
  }
  module.outputs.push_back(std::move(output));
  return phases;
}

}  // namespace warpjet
