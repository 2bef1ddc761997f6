#include "source/source.hpp"

namespace warpjet::source {

namespace {

constexpr int maxRounds = 4;

}  // namespace

std::string Source::problem() const {
  return parsed_.problems.any() ? parsed_.problems.message(parsed_.source->lines) : "";
}

std::vector<FunctionHead> Source::functions() const {
  std::vector<FunctionHead> heads;
  const Tree& tree = parsed_.tree;
  if (parsed_.problems.any()) return heads;
  for (std::uint32_t i = 0; i < tree.functions.size(); ++i) {
    const Function& function = tree.functions[i];
    if (function.body == nothing) continue;
    FunctionHead head{i, tree.types.name(function.type), std::string(function.name), {}};
    for (const Parameter& parameter : function.parameters) {
      const std::string_view name = tree.variables[parameter.variable].name;
      head.parameters.push_back({tree.types.name(parameter.type),
                                 name.empty() ? "?" : std::string(name),
                                 parameter.direction != Parameter::Direction::In});
    }
    heads.push_back(std::move(head));
  }
  return heads;
}

Listing Source::lower(int function, int maxIterations) {
  auto& [source, problems, tree] = parsed_;
  if (problems.any()) return {};
  Lowered lowered = Lowering(tree, problems, maxIterations).lower(function);
  // Inlining calls can make the caller long enough to stay a function itself. If that is called
  // only once, it should be inlined, too, so this is repeated.
  std::set<RoutineKey> inlined;
  for (int round = 0; round < maxRounds && !problems.any(); ++round) {
    const auto once = calledOnce(lowered.recorder, lowered.routines, lowered.results);
    if (once.empty()) break;
    inlined.insert(once.begin(), once.end());
    lowered = Lowering(tree, problems, maxIterations, inlined).lower(function);
  }
  if (problems.any()) return {};
  Listing listing = list(lowered, tree.types);
  if (lowered.cutOff.any()) listing.cutOff = lowered.cutOff.message(source->lines);
  return listing;
}

}  // namespace warpjet::source
