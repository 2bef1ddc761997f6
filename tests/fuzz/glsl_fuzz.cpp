// Any text for the front end: it ends in one sentence with its place, or in lists whose operands
// all stand before them.
#include <cstdint>
#include <string>

#include "fuzz/require.hpp"
#include "glsl/glsl.hpp"

namespace warpjet::glsl {
namespace {

void requireSentence(const std::string& problem) {
  require(problem.starts_with("line "), "a sentence names its line", problem);
  require(problem.find(", column ") != problem.npos, "a sentence names its column", problem);
  const bool ends = problem.find(".\n") != problem.npos || problem.find("?\n") != problem.npos;
  require(ends, "a sentence ends", problem);
  require(problem.ends_with('^'), "a caret stands under the place", problem);
  require(problem.size() < 2000, "a sentence is not long", std::to_string(problem.size()));
}

void requireOrder(const Listing& listing) {
  const auto& words = listing.words;
  std::uint32_t made = 0;
  const auto before = [&](std::uint32_t operand) {
    require(operand < made, "an operand stands before what it is used in",
            std::to_string(operand) + " of " + std::to_string(made));
  };
  for (std::size_t at = 0; at < words.size(); ++made) {
    const auto code = static_cast<Code>(words[at++]);
    switch (code) {
      case Code::Constant:
      case Code::Whole:
        require(words[at++] < listing.constants.size(), "a constant is there");
        break;
      case Code::Argument:
      case Code::Uniform:
        at += 3;
        break;
      case Code::Component:
        before(words[at]);
        at += 3;
        break;
      case Code::ImageSize:
        ++at;
        break;
      case Code::Texel:
      case Code::FetchedTexel:
        before(words[at + 1]);
        at += 2;
        break;
      default:
        require(codeNames[static_cast<std::size_t>(code)][0] != '\0', "an operation has a name",
                std::to_string(static_cast<int>(code)));
        for (std::uint32_t count = words[at++]; count > 0; --count) before(words[at++]);
    }
  }
  for (const std::uint32_t result : listing.results) before(result);
  for (const double value : listing.constants)
    require(value >= -3.5e38 && value <= 3.5e38, "a constant is a float", exactly(value));
}

void check(std::string text) {
  Source source(std::move(text));
  if (!source.problem().empty()) return requireSentence(source.problem());
  const std::string lines = source.functions();
  // The last one, as calls it all the others.
  if (lines.empty()) return;
  const auto start = lines.rfind('\n', lines.size() - 2);
  const int last = std::atoi(lines.c_str() + (start == lines.npos ? 0 : start + 1));
  const Listing listing = source.lower(last, 3);
  if (!source.problem().empty()) return requireSentence(source.problem());
  requireOrder(listing);
}

}  // namespace
}  // namespace warpjet::glsl

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  warpjet::glsl::check({reinterpret_cast<const char*>(data), size});
  return 0;
}
