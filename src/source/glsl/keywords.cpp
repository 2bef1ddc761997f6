#include "source/glsl/keywords.hpp"

#include <algorithm>
#include <iterator>

#include "source/glsl/versions.hpp"
#include "source/problems.hpp"
#include "source/types.hpp"

namespace warpjet::source::glsl {

namespace {

struct Word {
  std::string_view text;
  // The only version that reserves the word; 0 if both do.
  int version = 0;
};

// GLSL ES 3.00, section 3.8, and 1.00, section 3.7; supported types are in a table of their own.
// clang-format off
constexpr Word words[]{
    {"const"}, {"uniform"}, {"layout", 300}, {"centroid", 300}, {"flat"}, {"smooth", 300}, {"break"},
    {"continue"}, {"do"}, {"for"}, {"while"}, {"switch"}, {"case", 300}, {"default"}, {"if"},
    {"else"}, {"in"}, {"out"}, {"inout"}, {"true"}, {"false"}, {"invariant"}, {"discard"},
    {"return"}, {"lowp"}, {"mediump"}, {"highp"}, {"precision"}, {"struct"}, {"attribute"},
    {"varying"}, {"sampler3D"}, {"samplerCube"}, {"sampler2DArray", 300}, {"sampler2DShadow"},
    {"isampler2D", 300}, {"usampler2D", 300},
};

// Words reserved for future use. Without #version, words reserved only in 3.00 are valid names.
constexpr Word reserved[]{
    {"asm"}, {"class"}, {"union"}, {"enum"}, {"typedef"}, {"template"}, {"this"}, {"packed", 100},
    {"goto"}, {"inline"}, {"noinline"}, {"volatile"}, {"public"}, {"static"}, {"extern"},
    {"external"}, {"interface"}, {"long"}, {"short"}, {"double"}, {"half"}, {"fixed"}, {"unsigned"},
    {"superp"}, {"input"}, {"output"}, {"hvec2"}, {"hvec3"}, {"hvec4"}, {"dvec2"}, {"dvec3"},
    {"dvec4"}, {"fvec2"}, {"fvec3"}, {"fvec4"}, {"sampler1D"}, {"sampler1DShadow"},
    {"sampler2DRect"}, {"sampler3DRect"}, {"sampler2DRectShadow"}, {"image1DShadow"},
    {"image2DShadow"}, {"image1DArrayShadow"}, {"image2DArrayShadow"}, {"sizeof"}, {"cast"},
    {"namespace"}, {"using"},
    {"coherent", 300}, {"restrict", 300}, {"readonly", 300}, {"writeonly", 300}, {"resource", 300},
    {"atomic_uint", 300}, {"noperspective", 300}, {"patch", 300}, {"sample", 300},
    {"subroutine", 300}, {"common", 300}, {"partition", 300}, {"active", 300}, {"filter", 300},
    {"image1D", 300}, {"iimage1D", 300}, {"uimage1D", 300}, {"image2D", 300}, {"iimage2D", 300},
    {"uimage2D", 300}, {"image3D", 300}, {"iimage3D", 300}, {"uimage3D", 300}, {"imageCube", 300},
    {"iimageCube", 300}, {"uimageCube", 300}, {"imageBuffer", 300}, {"iimageBuffer", 300},
    {"uimageBuffer", 300}, {"image1DArray", 300}, {"iimage1DArray", 300}, {"uimage1DArray", 300},
    {"image2DArray", 300}, {"iimage2DArray", 300}, {"uimage2DArray", 300}, {"sampler1DArray", 300},
    {"sampler1DArrayShadow", 300}, {"isampler1D", 300}, {"isampler1DArray", 300},
    {"usampler1D", 300}, {"usampler1DArray", 300}, {"isampler2DRect", 300}, {"usampler2DRect", 300},
    {"samplerBuffer", 300}, {"isamplerBuffer", 300}, {"usamplerBuffer", 300}, {"sampler2DMS", 300},
    {"isampler2DMS", 300}, {"usampler2DMS", 300}, {"sampler2DMSArray", 300},
    {"isampler2DMSArray", 300}, {"usampler2DMSArray", 300}, {"isampler3D", 300},
    {"isamplerCube", 300}, {"isampler2DArray", 300}, {"usampler3D", 300}, {"usamplerCube", 300},
    {"usampler2DArray", 300}, {"samplerCubeShadow", 300}, {"sampler2DArrayShadow", 300},
};
// clang-format on

template <std::size_t size>
bool hasWord(const Word (&all)[size], std::string_view name, int version, bool ofEither) {
  return std::any_of(std::begin(all), std::end(all), [&](const Word& word) {
    return word.text == name && (word.version == 0 || ofEither || word.version == version);
  });
}

}  // namespace

bool isReserved(std::string_view name, int version) {
  return hasWord(reserved, name, version ? version : 100, false) ||
         (version == 100 && name == "sampler3D");
}

bool isKeyword(std::string_view name, int version) {
  return hasWord(words, name, version, version == 0) || isReserved(name, version) ||
         (findType(name) && versionProblem(version, name).empty());
}

std::string nameProblem(std::string_view name, int version) {
  const std::string start = quote(name) + " cannot be a name: ";
  if (isReserved(name, version)) return start + "GLSL reserves this word; use another name";
  if (isKeyword(name, version)) return start + "it is a keyword";
  for (const std::string_view prefix : {"gl_", "webgl_", "_webgl_"})
    if (name.starts_with(prefix))
      return start + "names that start with " + std::string(prefix) + " are reserved";
  if (name.find("__") != name.npos)
    return start + "names with two consecutive underscores are reserved";
  if (const std::size_t maxLength = version == 100 ? 256 : 1024; name.size() > maxLength)
    return start + "it is longer than " + std::to_string(maxLength) + " characters";
  return {};
}

}  // namespace warpjet::source::glsl
