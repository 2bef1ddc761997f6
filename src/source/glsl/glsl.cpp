#include "source/glsl/glsl.hpp"

#include "source/glsl/parser.hpp"
#include "source/glsl/preprocess.hpp"
#include "source/glsl/tokens.hpp"

namespace warpjet::source::glsl {

Parsed parse(std::string_view text) {
  Parsed made{std::make_unique<const Lines>(text), {}, {}};
  const Lines& lines = *made.text;
  PreprocessedSource read =
      preprocess(readTokens(lines.joined, made.problems, lines.joins), made.problems);
  if (!made.problems.any()) made.tree = Parser(std::move(read), made.problems).parse();
  return made;
}

}  // namespace warpjet::source::glsl
