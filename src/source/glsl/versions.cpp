#include "source/glsl/versions.hpp"

#include "source/problems.hpp"

namespace warpjet::source::glsl {

namespace {

struct Row {
  // Features without a keyword have spaces in their name, which is used in the message unchanged.
  std::string_view what;
  int version;
  // The alternative in the other version; empty if only another version helps.
  std::string_view advice{};
};

constexpr std::string_view
    ints = "use int",
    floats = "use floats", bits = "use floor() and mod()", square = "use mat2, mat3 or mat4",
    elements = "write its elements one by one",
    counting = "count up to a constant, as in for (int i = 0; i < 8; i++)",
    heads = "write it as for (int i = 0; i < 8; i++), with the counter on the left",
    byHand = "write a function that computes it";

constexpr Row rows[]{
    // declarations
    {"attribute", 100, "write \"in\""},
    {"varying", 100, "write \"out\""},
    {"in before a global variable", 300, "write attribute"},
    {"out before a global variable", 300, "write varying"},
    {"layout", 300, "leave it out"},
    {"flat", 300, "leave it out"},
    {"smooth", 300, "leave it out"},
    {"centroid", 300, "leave it out"},

    // types
    {"uint", 300, ints},
    {"uvec2", 300, "use ivec2"},
    {"uvec3", 300, "use ivec3"},
    {"uvec4", 300, "use ivec4"},
    {"mat2x2", 300, "write mat2"},
    {"mat2x3", 300, square},
    {"mat2x4", 300, square},
    {"mat3x2", 300, square},
    {"mat3x3", 300, "write mat3"},
    {"mat3x4", 300, square},
    {"mat4x2", 300, square},
    {"mat4x3", 300, square},
    {"mat4x4", 300, "write mat4"},

    // values
    {"a whole number with a u", 300, ints},
    {"a number with an f", 300, "leave the f out"},
    {"an array made in one expression", 300, elements},
    {"an array without a length", 300, "write its length after its name"},
    {"the length of an array before its name", 300, "write it after the name"},
    {".length()", 300, "write the number"},
    {"an assignment of arrays", 300, elements},
    {"a comparison of arrays", 300, "compare their elements"},
    {"an array returned by a function", 300, "return it by an out parameter"},
    {"an index that is not constant", 300, "use a constant, or the counter of a loop"},

    // operators
    {"%", 300, "use mod(x, y) of floats"},
    {"<<", 300, "multiply by a power of two"},
    {">>", 300, "divide by a power of two and use floor()"},
    {"&", 300, bits},
    {"|", 300, bits},
    {"^", 300, bits},
    {"~", 300, bits},

    // statements
    {"switch", 300, "write if and else"},
    {"while", 300, counting},
    {"do", 300, counting},
    {"a for whose counter does not start, end and step by constants", 300, heads},
    {"changing a loop's counter in its body", 300, "change another variable"},

    // built-in functions
    {"sinh", 300, byHand},
    {"cosh", 300, byHand},
    {"tanh", 300, byHand},
    {"asinh", 300, byHand},
    {"acosh", 300, byHand},
    {"atanh", 300, byHand},
    {"trunc", 300, "write sign(x) * floor(abs(x))"},
    {"round", 300, "write floor(x + 0.5)"},
    {"roundEven", 300, "write floor(x + 0.5), which rounds halves up"},
    {"modf", 300, "use floor and fract"},
    {"isnan", 300, "write x != x"},
    {"isinf", 300, "write abs(x) > 3.4e38"},
    {"floatBitsToInt", 300},
    {"floatBitsToUint", 300},
    {"intBitsToFloat", 300},
    {"uintBitsToFloat", 300},
    {"packSnorm2x16", 300},
    {"unpackSnorm2x16", 300},
    {"packUnorm2x16", 300},
    {"unpackUnorm2x16", 300},
    {"packHalf2x16", 300},
    {"unpackHalf2x16", 300},
    {"outerProduct", 300, byHand},
    {"transpose", 300, byHand},
    {"determinant", 300, byHand},
    {"inverse", 300, byHand},
    {"abs, sign, min, max or clamp of whole numbers", 300, floats},
    {"mix by a bvec", 300, "mix by a vector of 0.0 and 1.0"},
    {"texture", 300, "write texture2D"},
    {"textureLod", 300, "write texture2DLod"},
    {"textureSize", 300, "pass the size as a uniform"},
    {"texelFetch", 300, "write texture2D(image, (vec2(ij) + 0.5) / size)"},
    {"textureProj", 300, "write texture2DProj"},
    {"textureProjLod", 300, "write texture2DProjLod"},
    {"textureOffset", 300, "add the offset, divided by the size of the image"},
    {"textureLodOffset", 300, "add the offset, divided by the size of the image"},
    {"textureProjOffset", 300, "add the offset, divided by the size of the image"},
    {"textureProjLodOffset", 300, "add the offset, divided by the size of the image"},
    {"texelFetchOffset", 300, "write texture2D(image, (vec2(ij) + 0.5) / size)"},
    {"texture2D", 100, "write texture"},
    {"texture2DLod", 100, "write textureLod"},
    {"texture2DProj", 100, "write textureProj"},
    {"texture2DProjLod", 100, "write textureProjLod"},
    {"a function with the name of a built-in one", 100, "give it another name"},

    // variables of the language
    {"gl_VertexID", 300, "give each vertex an attribute"},
    {"gl_InstanceID", 300, "give each instance an attribute"},
    {"gl_FragColor", 100, "declare an out vec4"},
    {"gl_FragData", 100, "declare an array of out vec4"},
    {"gl_FragDepth", 300},
    {"gl_MaxVaryingVectors", 100, "write gl_MaxVertexOutputVectors"},
    {"gl_MaxVertexOutputVectors", 300, "write gl_MaxVaryingVectors"},
    {"gl_MaxFragmentInputVectors", 300, "write gl_MaxVaryingVectors"},
    {"gl_MinProgramTexelOffset", 300},
    {"gl_MaxProgramTexelOffset", 300},
    {"a block of uniforms", 300, "declare them one by one"},
};

}  // namespace

std::string versionProblem(int version, std::string_view what) {
  if (version == 0) return {};
  for (const Row& row : rows) {
    if (row.what != what || row.version == version) continue;
    const bool isWord = what.find(' ') == what.npos;
    const std::string subject = isWord ? quote(what) : std::string(what);
    const std::string advice = row.advice.empty() ? "" : std::string(row.advice) + ", or ";
    return version == 100 ? subject + " is not in GLSL ES 1.00, the language of #version 100; " +
                                advice + "begin the source with #version 300 es"
                          : subject + " is not in GLSL ES 3.00, the language of #version 300 es; " +
                                std::string(row.advice);
  }
  return {};
}

}  // namespace warpjet::source::glsl
