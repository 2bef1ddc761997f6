#include "source/wgsl/wgsl.hpp"

#include "source/wgsl/parser.hpp"
#include "source/wgsl/tokens.hpp"

namespace warpjet::source::wgsl {

Parsed parse(std::string_view text) {
  Parsed made{std::make_unique<const Lines>(text), {}, {}};
  std::vector<Token> tokens = readTokens(made.text->separate, made.problems);
  if (!made.problems.any()) made.tree = Parser(std::move(tokens), made.problems).parse();
  return made;
}

}  // namespace warpjet::source::wgsl
