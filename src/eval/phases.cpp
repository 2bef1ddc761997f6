#include "eval/phases.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include "eval/dependence.hpp"
#include "eval/fronts.hpp"
#include "eval/kinks.hpp"
#include "eval/slope_jumps.hpp"
#include "eval/varying_part.hpp"
#include "graph/expression.hpp"
#include "graph/reachable.hpp"
#include "noise/noise.hpp"

namespace warpjet {

namespace {

// The step of a noise, as a share of the wavelength of its second octave; later octaves add little.
constexpr double stepOfNoise = 0.36;
constexpr int octavesOfNoise = 2;

// The max change of a normal's direction along a side, in radians. Between vertices whose normals
// are almost opposite, the normal turns within a short part of the side, and a surface that it
// moves bends there.
constexpr double stepOfNormal = 1;

// With more phases, because of loops, those in loops are left out: all are evaluated at each
// sample.
constexpr std::size_t maxPhases = 32;

// A function with more kinks, such as a noise in shader source, has too many to cut a mesh at them.
constexpr std::size_t maxKinks = 8;
// A function with more limits has none of them tested for being a kink, since that takes long.
constexpr std::size_t maxLimits = 4 * maxKinks;

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

bool isIn(std::span<const std::uint32_t> inputs, std::uint32_t input) {
  return std::find(inputs.begin(), inputs.end(), input) != inputs.end();
}

// Tests whether a node depends on no other inputs than these, given by number.
bool readsOnly(const Graph& graph, NodeId root, std::span<const std::uint32_t> inputs) {
  const std::vector<NodeId> nodes = reachable(graph, std::span(&root, 1));
  return std::none_of(nodes.begin(), nodes.end(), [&](NodeId id) {
    return graph.isInput(id) && !isIn(inputs, graph.node(id).operands[0]);
  });
}

// Tests whether any of the nodes is a component of an input, given by number.
bool readsInput(const Graph& graph, std::span<const NodeId> nodes, std::uint32_t input) {
  return std::any_of(nodes.begin(), nodes.end(), [&](NodeId id) {
    return graph.isInput(id) && graph.node(id).operands[0] == input;
  });
}

// Returns a vector of three components with length 1, or zero if the input is zero. Adapters may
// give normals of other lengths.
std::vector<NodeId> directionOf(Graph& graph, std::uint32_t input) {
  const auto component = [&](int i) { return Expression{&graph, graph.component(input, i)}; };
  const Expression x = component(0), y = component(1), z = component(2);
  constexpr double tiny = 1e-30;
  const Expression length = max(sqrt(x * x + y * y + z * z), tiny);
  return {(x / length).id, (y / length).id, (z / length).id};
}

}  // namespace

Phases addPhases(Module& module, std::span<const std::uint32_t> results,
                 std::span<const std::uint32_t> varying) {
  // A loaded graph has no room for new nodes: those of unrolled loops and of varying parts.
  module.graph = module.graph.copy();
  Graph& graph = module.graph;
  const std::vector<NodeId> roots = module.roots(results);
  const std::vector<NodeId> unrolled = canUnroll(graph) ? unrollFolds(graph, roots) : roots;
  Dependence dependence(graph, varying);
  VaryingParts varyingParts(graph, dependence);
  const auto isVarying = [&](NodeId id) { return dependence.isVarying(id); };
  const auto isInLoop = [&](NodeId id) { return dependence.isInLoop(id); };
  std::vector<NodeId> allRoots = roots;
  allRoots.insert(allRoots.end(), unrolled.begin(), unrolled.end());
  for (const NodeId id : reachable(graph, allRoots)) {
    dependence.add(id);
    varyingParts.add(id);
  }
  std::map<std::vector<NodeId>, double> steps;
  const auto addPhase = [&](NodeId id) {
    std::vector<NodeId> point = pointOf(module, id);
    if (std::none_of(point.begin(), point.end(), isVarying) ||
        std::any_of(point.begin(), point.end(), isInLoop))
      return;
    const double step =
        graph.isLibraryCall(id) ? stepOfCall(module, id) : *stepOfWave(graph.node(id).op);
    for (NodeId& coordinate : point) coordinate = varyingParts[coordinate];
    const auto [found, isNew] = steps.try_emplace(point, step);
    if (!isNew) found->second = std::min(found->second, step);
  };
  std::vector<FrontAt> fronts, kinks;
  const auto add = [&](std::vector<FrontAt>& to, const FrontAt& front) {
    if (isVarying(front.argument) && std::find(to.begin(), to.end(), front) == to.end())
      to.push_back(front);
  };
  const std::vector<NodeId> nodes = reachable(graph, roots);
  for (const NodeId id : nodes) {
    addPhase(id);
    if (const std::optional<FrontAt> front = frontOf(graph, id)) add(fronts, *front);
  }
  const std::optional<std::uint32_t> normal = graph.findInput("normal");
  if (normal && readsInput(graph, nodes, *normal) && isIn(varying, *normal)) {
    steps.try_emplace(directionOf(graph, *normal), stepOfNormal);
  }
  const auto stepsOutside = steps;
  for (const NodeId id : reachable(graph, unrolled)) addPhase(id);
  if (steps.size() > std::max(maxPhases, stepsOutside.size())) steps = stepsOutside;
  const std::vector<FrontAt> found = kinksOf(graph, nodes, roots);
  dependence.addNew();
  for (const FrontAt& kink : found) add(kinks, kink);
  for (auto& [argument, kink] : kinks) kink.second = readsOnly(graph, argument, varying) ? 1 : 0;
  if (kinks.size() <= maxLimits) removeSmoothKinks(kinks, module, results, varying);
  if (kinks.size() <= maxKinks) fronts.insert(fronts.end(), kinks.begin(), kinks.end());
  Phases all;
  Output output{.name = "phases", .shape = {}, .components = {}};
  for (const auto& [point, step] : steps) {
    all.phases.push_back({static_cast<std::uint32_t>(point.size()), step});
    output.components.insert(output.components.end(), point.begin(), point.end());
  }
  for (const auto& [argument, front] : fronts) {
    all.fronts.push_back(front);
    output.components.push_back(argument);
  }
  module.outputs.push_back(std::move(output));
  return all;
}

}  // namespace warpjet
