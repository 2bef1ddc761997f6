#include "glsl/keywords.hpp"

#include <algorithm>
#include <iterator>

#include "glsl/types.hpp"

namespace warpjet::glsl {

namespace {

// GLSL ES 3.00, section 3.8, as far as a text might try; types are in their table.
// clang-format off
constexpr std::string_view words[]{
    "const", "uniform", "layout", "centroid", "flat", "smooth", "break", "continue", "do", "for",
    "while", "switch", "case", "default", "if", "else", "in", "out", "inout", "true", "false",
    "invariant", "discard", "return", "lowp", "mediump", "highp", "precision", "struct",
    "attribute", "varying", "goto", "class", "union", "enum", "typedef", "template", "this",
    "inline", "noinline", "volatile", "public", "static", "extern", "external", "interface",
    "long", "short", "double", "half", "fixed", "unsigned", "superp", "input", "output", "sizeof",
    "cast", "namespace", "using", "sampler3D", "samplerCube", "sampler2DArray", "sampler2DShadow",
    "isampler2D", "usampler2D",
};
// clang-format on

}  // namespace

bool isKeyword(std::string_view name) {
  return std::find(std::begin(words), std::end(words), name) != std::end(words) || findType(name);
}

}  // namespace warpjet::glsl
