#include "source/wgsl/wgsl.hpp"

#include "source/wgsl/parser.hpp"
#include "source/wgsl/tokens.hpp"

namespace warpjet::source::wgsl {

Parsed parse(std::string_view source) {
  Parsed parsed{std::make_unique<const Lines>(source), {}, {}};
  std::vector<Token> tokens = readTokens(parsed.source->lines, parsed.problems);
  if (!parsed.problems.any()) parsed.tree = Parser(std::move(tokens), parsed.problems).parse();
  return parsed;
}

}  // namespace warpjet::source::wgsl
