#include "mesh/gltf/json_text.hpp"

#include <cstddef>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

// glTF itself nests about 8 deep; the rest is for `extras`. A tinygltf::Node takes about 700 bytes.
constexpr std::size_t maxDepth = 64;
constexpr std::size_t maxValues = std::size_t{1} << 23;
constexpr std::size_t maxObjects = std::size_t{1} << 20;

void failImplausible(const std::string& what) {
  throw FileProblem("the description of the model (its JSON) " + what +
                    ", which no exporter writes; export the model again.");
}

// Counts brackets and commas outside of strings, without parsing the rest.
void checkExtent(std::string_view text) {
  std::size_t depth = 0, values = 1, objects = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    switch (text[i]) {
      case '"':
        for (++i; i < text.size() && text[i] != '"'; ++i) i += text[i] == '\\';
        break;
      case '{':
        ++objects;
        [[fallthrough]];
      case '[':
        ++values;
        if (++depth > maxDepth) failImplausible("is nested more than 64 deep");
        break;
      case '}':
      case ']':
        depth -= depth > 0;
        break;
      case ',':
        ++values;
        break;
      default:
        break;
    }
  }
  if (values > maxValues || objects > maxObjects)
    failImplausible("has more than " + groupDigits(maxValues) + " values or " +
                    groupDigits(maxObjects) + " objects");
}

}  // namespace

nlohmann::json parseJson(std::string_view text) {
  checkExtent(text);
  try {
    // The text ends at a zero byte, with which some exporters pad instead of spaces.
    return nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::parse_error& error) {
    throw FileProblem("the description of the model is broken JSON at its byte " +
                      groupDigits(error.byte) + " of " + groupDigits(text.size()) +
                      "; export or download it again.");
  } catch (const nlohmann::json::out_of_range&) {
    throw FileProblem(
        "the description of the model has a number too large to be one; export it again.");
  }
}

}  // namespace warpjet
