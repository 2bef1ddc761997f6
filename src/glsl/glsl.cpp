#include "glsl/glsl.hpp"

#include "glsl/parser.hpp"
#include "glsl/preprocess.hpp"
#include "glsl/tokens.hpp"

namespace warpjet::glsl {

Source::Source(std::string_view text) : text_(text) {
  Preprocessed read = preprocess(readTokens(text_.joined, problems_, text_.joins), problems_);
  if (!problems_.any()) tree_ = Parser(std::move(read), problems_).parse();
}

std::string Source::functions() const {
  std::string lines;
  if (problems_.any()) return lines;
  for (std::size_t i = 0; i < tree_.functions.size(); ++i) {
    const Function& function = tree_.functions[i];
    if (function.body == nothing) continue;
    lines += std::to_string(i) + ' ' + tree_.types.name(function.type) + ' ' +
             std::string(function.name);
    for (const Parameter& parameter : function.parameters) {
      const bool isIn = parameter.direction == Parameter::Direction::In;
      const std::string_view name = tree_.variables[parameter.variable].name;
      lines += ' ' + tree_.types.name(parameter.type) + (isIn ? ' ' : '&') +
               (name.empty() ? "?" : std::string(name));
    }
    lines += '\n';
  }
  return lines;
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
