#include "glsl/glsl.hpp"

#include "glsl/parser.hpp"
#include "glsl/preprocess.hpp"
#include "glsl/tokens.hpp"

namespace warpjet::glsl {

Source::Source(std::string_view text) : text_(text) {
  Preprocessed read = preprocess(readTokens(text_.joined, problems_, text_.joins), problems_);
  if (!problems_.any()) tree_ = Parser(std::move(read), problems_).parse();
}

std::vector<FunctionHead> Source::functions() const {
  std::vector<FunctionHead> heads;
  if (problems_.any()) return heads;
  for (std::uint32_t i = 0; i < tree_.functions.size(); ++i) {
    const Function& function = tree_.functions[i];
    if (function.body == nothing) continue;
    FunctionHead head{i, tree_.types.name(function.type), std::string(function.name), {}};
    for (const Parameter& parameter : function.parameters) {
      const std::string_view name = tree_.variables[parameter.variable].name;
      head.parameters.push_back({tree_.types.name(parameter.type),
                                 name.empty() ? "?" : std::string(name),
                                 parameter.direction != Parameter::Direction::In});
    }
    heads.push_back(std::move(head));
  }
  return heads;
}

Listing Source::lower(int function, int maxIterations) {
  if (problems_.any()) return {};
  Lowered lowered = Lowering(tree_, problems_, maxIterations).lower(function);
  if (problems_.any()) return {};
  auto once = calledOnce(lowered.recorder, lowered.routines, lowered.results);
  if (!once.empty())
    lowered = Lowering(tree_, problems_, maxIterations, std::move(once)).lower(function);
  if (problems_.any()) return {};
  return list(lowered, tree_.types);
}

}  // namespace warpjet::glsl
