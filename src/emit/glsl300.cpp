#include "emit/glsl.hpp"

namespace warpjet {

// The GLSL ES 3.00 specification, sections 3.8 and 8.
constinit const Dialect glsl300{
    .name = "glsl300",
    .language = ops::Language::Glsl300,
    .family = "GLSL",
    .sourceKey = "glsl",
    .operators = "%&|^~?:",
    .constructors =
        " float int uint bool vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 "
        "bvec4 mat2 mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ",
    .hasTemplates = false,
    .builtIns =
        " gl_VertexID gl_InstanceID gl_Position gl_PointSize gl_FragCoord gl_FrontFacing "
        "gl_PointCoord ",
    .nonFloats = " gl_VertexID gl_InstanceID gl_FrontFacing ",
    .keywords =
        " const uniform layout centroid flat smooth break continue do for while switch case "
        "default if else in out inout float int void bool true false invariant discard return "
        "mat2 mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 vec2 vec3 "
        "vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 uint uvec2 uvec3 uvec4 lowp mediump highp "
        "precision sampler2D sampler3D samplerCube sampler2DShadow samplerCubeShadow "
        "sampler2DArray sampler2DArrayShadow isampler2D isampler3D isamplerCube isampler2DArray "
        "usampler2D usampler3D usamplerCube usampler2DArray struct attribute varying coherent "
        "volatile restrict readonly writeonly resource atomic_uint noperspective patch sample "
        "subroutine common partition active asm class union enum typedef template this goto "
        "inline noinline volatile public static extern external interface long short double half "
        "fixed unsigned superp input output hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 fvec2 fvec3 "
        "fvec4 sampler3DRect filter image1D image2D image3D imageCube iimage1D iimage2D iimage3D "
        "iimageCube uimage1D uimage2D uimage3D uimageCube image1DArray image2DArray "
        "iimage1DArray iimage2DArray uimage1DArray uimage2DArray imageBuffer iimageBuffer "
        "uimageBuffer sampler1D sampler1DShadow sampler1DArray sampler1DArrayShadow isampler1D "
        "isampler1DArray usampler1D usampler1DArray sampler2DRect sampler2DRectShadow "
        "isampler2DRect usampler2DRect samplerExternalOES image1DShadow image2DShadow "
        "samplerBuffer isamplerBuffer usamplerBuffer sampler2DMS isampler2DMS usampler2DMS "
        "sampler2DMSArray isampler2DMSArray usampler2DMSArray sizeof cast namespace using ",
    .functions =
        " radians degrees sin cos tan asin acos atan pow exp log exp2 log2 sqrt inversesqrt abs "
        "sign floor ceil fract mod min max clamp mix step smoothstep length distance dot cross "
        "normalize faceforward reflect refract matrixCompMult lessThan lessThanEqual greaterThan "
        "greaterThanEqual equal notEqual any all not sinh cosh tanh asinh acosh atanh trunc "
        "round roundEven modf isnan isinf floatBitsToInt floatBitsToUint intBitsToFloat "
        "uintBitsToFloat packSnorm2x16 unpackSnorm2x16 packUnorm2x16 unpackUnorm2x16 "
        "packHalf2x16 unpackHalf2x16 outerProduct transpose determinant inverse textureSize "
        "texture textureProj textureLod textureOffset texelFetch texelFetchOffset "
        "textureProjOffset textureLodOffset textureProjLod textureProjLodOffset textureGrad "
        "textureGradOffset textureProjGrad textureProjGradOffset dFdx dFdy fwidth ",
    .maxNameLength = glsl::maxNameLength,
    .numbers = glsl::numbers,
    .vectors = glsl::vectors,
    .matrices = {{{"mat2", "mat2x3", "mat2x4"},
                  {"mat3x2", "mat3", "mat3x4"},
                  {"mat4x2", "mat4x3", "mat4"}}},
    .image = glsl::image,
    .missingTypes = "",
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
    .imageSize = "vec2(textureSize($0, 0))",
    .texel =
        R"(highp vec4 warpjetTexel(float x, float y, highp sampler2D image, float width, float height) {
  return texelFetch(image, ivec2(int(x), int(y)), 0);
}
)",
    .sampledTexel =
        R"(highp vec4 warpjetSampledTexel(float x, float y, highp sampler2D image, float width, float height) {
  return textureLod(image, vec2((x + 0.5) / width, (y + 0.5) / height), 0.0);
}
)",
    .across = glsl::across,
    .down = glsl::down};

}  // namespace warpjet
