#include "mesh/obj/mtl.hpp"

#include <cmath>

#include "mesh/text/lines.hpp"
#include "mesh/text/number.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

namespace {

std::string toLowerCase(std::string_view word) {
  std::string lower(word);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

// Reads the color on a line; a single number is a gray. Returns nullopt if there are no numbers, as
// after "spectral" and "xyz".
std::optional<std::array<float, 3>> colorOn(TextLine& line) {
  std::array<float, 3> color{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view word = line.word();
    if (word.empty() && i == 1) return std::array{color[0], color[0], color[0]};
    const std::optional<float> number = parseFloat(word);
    if (!number || !std::isfinite(*number)) return std::nullopt;
    color[i] = *number;
  }
  return color;
}

// Returns the max number of words after a texture option; all but the numbers of -o, -s and -t are
// required.
std::size_t wordsOf(std::string_view option) {
  if (option == "-o" || option == "-s" || option == "-t") return 3;
  return option == "-mm" ? 2 : 1;
}

// Returns the file name after the options; it may contain spaces.
std::string_view pictureNameOn(TextLine& line) {
  while (line.rest().starts_with('-')) {
    const std::string option = toLowerCase(line.word());
    const std::size_t words = wordsOf(option);
    for (std::size_t i = 0; i < words; ++i) {
      TextLine ahead = line;
      const std::string_view word = ahead.word();
      if (words == 3 && !parseFloat(word)) break;
      line = ahead;
    }
  }
  return line.rest();
}

}  // namespace

void readMaterials(std::string_view text, const std::string& uri, ObjMaterials& materials) {
  ObjMaterial* material = nullptr;
  for (TextLines lines(text, "mtl"); std::optional<TextLine> line = lines.next();) {
    const std::string word = toLowerCase(line->word());
    if (word == "newmtl") {
      material = &materials[std::string(line->rest())];
      *material = {};
    }
    if (!material) continue;
    if (word == "kd") material->color = colorOn(*line);
    if (word != "map_kd") continue;
    const std::string_view name = pictureNameOn(*line);
    material->picture = name.empty() ? "" : uriOfName(name, uri);
  }
}

}  // namespace warpjet
