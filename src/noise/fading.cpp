#include "noise/fading.hpp"

#include <numbers>

#include "graph/reachable.hpp"
#include "noise/noise.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// Noise keeps its full strength where a wave covers at least this number of pixels.
constexpr double pixelsPerWave = 4;

// The width of a pixel in the space of a point: the larger of its extents across and down.
Expression widthOfPixel(Library& library, const Numbers& p) {
  const auto extent = [&](const char* name) {
    const Definition change{.function = {name, 1, 1, 0}};
    Numbers changes;
    for (const Expression x : p) changes.push_back(library.call(change, {x})[0]);
    return dot(changes, changes);
  };
  return sqrt(max(extent(acrossName), extent(downName)));
}

class Fading {
 public:
  Fading(Graph& graph, Library& library)
      : graph_(graph), library_(library), replacements_(graph.size()) {}

  // Operands are visited before their users.
  void visit(NodeId id) {
    if (graph_.isLeaf(id) || graph_.isList(id) || graph_.isStateOrList(id)) return;
    replacements_[index(id)] = replace(id);
  }

  NodeId replacementOf(NodeId id) const {
    return graph_.isLeaf(id) ? id : replacements_[index(id)];
  }

 private:
  NodeId replace(NodeId id) {
    if (graph_.isCall(id)) return replaceCall(id);
    if (graph_.isResult(id))
      return graph_.result(replacementOf(graph_.operand(id, 0)), graph_.resultNumber(id));
    if (graph_.isFold(id)) return replaceFold(id);
    if (graph_.isOutcome(id))
      return graph_.outcome(replacementOf(graph_.operand(id, 0)), graph_.operand(id, 1));
    Operands<NodeId> operands{};
    for (int i = 0; i < graph_.arity(id); ++i) operands[i] = replacementOf(graph_.operand(id, i));
    return graph_.apply(graph_.node(id).op, operands);
  }

  NodeId replaceFold(NodeId id) {
    std::vector<State> states = graph_.states(id);
    for (auto& [local, start, next] : states) {
      start = replacementOf(start);
      next = replacementOf(next);
    }
    return graph_.fold(graph_.loopOf(id), states);
  }

  NodeId replaceCall(NodeId id) {
    std::vector<NodeId> arguments = graph_.arguments(id);
    for (NodeId& argument : arguments) argument = replacementOf(argument);
    const Function function = graph_.function(id);
    if (!function.isOurs() || library_.definition(function.name).maker != noiseFrom)
      return graph_.call(graph_.node(id).operands[1], arguments);
    const auto parameters = arguments.begin() + function.variables;
    Numbers given;
    for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
      if (argument == parameters) given.push_back(widthOfPixel(library_, given));
      given.push_back({&graph_, *argument});
    }
    const Definition fading = withFading(library_.definition(function.name));
    return graph_.operand(library_.call(fading, given)[0].id, 0);
  }

  Graph& graph_;
  Library& library_;
  std::vector<NodeId> replacements_;  // by node
};

}  // namespace

// The mean of a sine over a square whose sides have `share` of its wavelength is about
// exp(-(pi share)^2 / 6) of its value in the middle, to the second order of sin(x) / x.
Expression fade(Expression value, double mean, Expression pixel, double wavelength) {
  constexpr double decay = std::numbers::pi * std::numbers::pi / 6;
  const Expression share = pixel / wavelength;
  const Expression excess = max(share * share - 1 / (pixelsPerWave * pixelsPerWave), 0.0);
  return mean + (value - mean) * exp(-decay * excess);
}

std::vector<NodeId> fadeNoise(Graph& graph, Library& library, std::span<const NodeId> roots) {
  Fading fading(graph, library);
  for (const NodeId id : reachable(graph, roots)) fading.visit(id);
  std::vector<NodeId> faded;
  for (const NodeId root : roots) faded.push_back(fading.replacementOf(root));
  return faded;
}

}  // namespace warpjet
