#include "source/glsl/glsl.hpp"

#include "source/glsl/parser.hpp"
#include "source/glsl/preprocess.hpp"
#include "source/glsl/tokens.hpp"

namespace warpjet::source::glsl {

Parsed parse(std::string_view source) {
  Parsed parsed{std::make_unique<const Lines>(source), {}, {}};
  const Lines& lines = *parsed.source;
  PreprocessedSource preprocessed =
      preprocess(readTokens(lines.joined, parsed.problems, lines.joins), parsed.problems);
  if (!parsed.problems.any())
    parsed.tree = Parser(std::move(preprocessed), parsed.problems).parse();
  return parsed;
}

}  // namespace warpjet::source::glsl
