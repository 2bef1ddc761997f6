#include "glsl/keywords.hpp"

#include <algorithm>
#include <iterator>

#include "glsl/types.hpp"
#include "glsl/versions.hpp"

namespace warpjet::glsl {

namespace {

struct Word {
  std::string_view text;
  // The only one that keeps it; 0 where both do.
  int version = 0;
};

// GLSL ES 3.00, section 3.8, and 1.00, section 3.7, as far as a text might try; types are in their
// table.
// clang-format off
constexpr Word words[]{
    {"const"}, {"uniform"}, {"layout", 300}, {"centroid", 300}, {"flat"}, {"smooth", 300}, {"break"},
    {"continue"}, {"do"}, {"for"}, {"while"}, {"switch"}, {"case", 300}, {"default"}, {"if"},
    {"else"}, {"in"}, {"out"}, {"inout"}, {"true"}, {"false"}, {"invariant"}, {"discard"},
    {"return"}, {"lowp"}, {"mediump"}, {"highp"}, {"precision"}, {"struct"}, {"attribute"},
    {"varying"}, {"goto"}, {"class"}, {"union"}, {"enum"}, {"typedef"}, {"template"}, {"this"},
    {"inline"}, {"noinline"}, {"volatile"}, {"public"}, {"static"}, {"extern"}, {"external"},
    {"interface"}, {"long"}, {"short"}, {"double"}, {"half"}, {"fixed"}, {"unsigned"}, {"superp"},
    {"input"}, {"output"}, {"sizeof"}, {"cast"}, {"namespace"}, {"using"}, {"sampler3D"},
    {"samplerCube"}, {"sampler2DArray", 300}, {"sampler2DShadow"}, {"isampler2D", 300},
    {"usampler2D", 300},
};
// clang-format on

}  // namespace

bool isKeyword(std::string_view name, int version) {
  const auto isIt = [&](const Word& word) {
    return word.text == name && (word.version == 0 || version == 0 || word.version == version);
  };
  return std::any_of(std::begin(words), std::end(words), isIt) ||
         (findType(name) && versionProblem(version, name).empty());
}

}  // namespace warpjet::glsl
