#include "emit/glsl.hpp"

namespace warpjet {

// The GLSL ES 1.00 specification, sections 3.6 and 8, and its extensions in WebGL. WebGL 1 can't
// query the size of an image, so the size is a variable of the host. Texels are read at their
// centers, where not even a linear filter mixes neighbors.
constinit const Dialect glsl100{
    .name = "glsl100",
    .language = ops::Language::Glsl100,
    .family = "GLSL",
    .sourceKey = "glsl",
    .operators = "?:",
    .constructors =
        " float int bool vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 ",
    .hasTemplates = false,
    .builtIns = " gl_Position gl_PointSize gl_FragCoord gl_FrontFacing gl_PointCoord ",
    .nonFloats = " gl_FrontFacing ",
    .keywords =
        " attribute const uniform varying break continue do for while if else in out inout float "
        "int void bool true false lowp mediump highp precision invariant discard return mat2 "
        "mat3 mat4 vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 sampler2D samplerCube "
        "struct asm class union enum typedef template this packed goto switch default inline "
        "noinline volatile public static extern external interface flat long short double half "
        "fixed unsigned superp input output hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 fvec2 fvec3 "
        "fvec4 sampler1D sampler3D sampler1DShadow sampler2DShadow sampler2DRect sampler3DRect "
        "sampler2DRectShadow sizeof cast namespace using ",
    .functions =
        " radians degrees sin cos tan asin acos atan pow exp log exp2 log2 sqrt inversesqrt abs "
        "sign floor ceil fract mod min max clamp mix step smoothstep length distance dot cross "
        "normalize faceforward reflect refract matrixCompMult lessThan lessThanEqual greaterThan "
        "greaterThanEqual equal notEqual any all not texture2D texture2DProj texture2DLod "
        "texture2DProjLod textureCube textureCubeLod texture2DLodEXT texture2DProjLodEXT "
        "textureCubeLodEXT texture2DGradEXT texture2DProjGradEXT textureCubeGradEXT dFdx dFdy "
        "fwidth ",
    .maxNameLength = glsl::maxNameLength,
    .numbers = glsl::numbers,
    .vectors = glsl::vectors,
    .matrices = {{{"mat2", "", ""}, {"", "mat3", ""}, {"", "", "mat4"}}},
    .image = glsl::image,
    .missingTypes = "WebGL 1 has only square matrices; use its columns, such as .column(0)",
    .numberSuffix = "",
    .declaration = glsl::declaration,
    .declaresSeveral = true,
    .definition = glsl::definition,
    .variable = glsl::definition,
    .loop = glsl::loop,
    .construction = glsl::construction,
    .splat = glsl::splat,
    .function = glsl::function,
    .parameter = glsl::parameter,
    .structure = glsl::structure,
    .member = glsl::member,
    .imageSize = "$0Size",
    .texel =
        R"(highp vec4 warpjetTexel(float x, float y, highp sampler2D image, float width, float height) {
  return texture2D(image, vec2((x + 0.5) / width, (y + 0.5) / height));
}
)",
    .sampledTexel =
        R"(highp vec4 warpjetSampledTexel(float x, float y, highp sampler2D image, float width, float height) {
  return texture2D(image, vec2((x + 0.5) / width, (y + 0.5) / height));
}
)",
    .across = glsl::across,
    .down = glsl::down};

}  // namespace warpjet
