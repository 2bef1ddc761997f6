#include "emit/fading.hpp"

#include "emit/rewriter.hpp"
#include "emit/screen.hpp"
#include "noise/noise.hpp"
#include "noise/random.hpp"

namespace warpjet {

namespace {

// Returns the width of a pixel in the space of a point: the larger of its extents across and down.
Expression widthOfPixel(Library& library, const Numbers& p) {
  const auto squaredExtent = [&](const char* name) {
    Numbers changes;
    for (const Expression x : p) changes.push_back(changeOnScreen(library, name, x));
    return dot(changes, changes);
  };
  return sqrt(max(squaredExtent(acrossName), squaredExtent(downName)));
}

class Fading : public Rewriter {
 public:
  Fading(Graph& graph, Library& library, Comments& comments)
      : Rewriter(graph, comments), library_(library) {}

 private:
  NodeId replaceCall(NodeId id) override {
    const Function function = graph_.function(id);
    if (!function.isFromLibrary() || library_.definition(function.name).maker != noiseFrom)
      return Rewriter::replaceCall(id);
    const std::vector<NodeId> arguments = newArguments(id);
    const auto parameters = arguments.begin() + function.variables;
    // The coordinates of the point are first; the width of a pixel follows them.
    Numbers withWidth;
    for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
      if (argument == parameters) withWidth.push_back(widthOfPixel(library_, withWidth));
      withWidth.push_back({&graph_, *argument});
    }
    const Definition fading = withFading(library_.definition(function.name));
    return graph_.operand(library_.call(fading, withWidth)[0].id, 0);
  }

  Library& library_;
};

}  // namespace

std::vector<NodeId> fadeNoise(Graph& graph, Library& library, std::span<const NodeId> roots,
                              Comments& comments) {
  return Fading(graph, library, comments).rewrite(roots);
}

}  // namespace warpjet
