#include "emit/dialect.hpp"

namespace warpjet {

// The GLSL ES 3.00 specification, section 3.8.
const Dialect glsl300{
    "glsl300", true,
    " float int uint bool vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 "
    "mat2 "
    "mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ",
    " gl_VertexID gl_InstanceID gl_Position gl_PointSize gl_FragCoord gl_FrontFacing "
    "gl_PointCoord ",
    " const uniform layout centroid flat smooth break continue do for while switch case default if "
    "else in out inout float int void bool true false invariant discard return mat2 mat3 mat4 "
    "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 vec2 vec3 vec4 ivec2 ivec3 "
    "ivec4 bvec2 bvec3 bvec4 uint uvec2 uvec3 uvec4 lowp mediump highp precision sampler2D "
    "sampler3D samplerCube sampler2DShadow samplerCubeShadow sampler2DArray sampler2DArrayShadow "
    "isampler2D isampler3D isamplerCube isampler2DArray usampler2D usampler3D usamplerCube "
    "usampler2DArray struct attribute varying coherent volatile restrict readonly writeonly "
    "resource atomic_uint noperspective patch sample subroutine common partition active asm class "
    "union enum typedef template this goto inline noinline volatile public static extern external "
    "interface long short double half fixed unsigned superp input output hvec2 hvec3 hvec4 dvec2 "
    "dvec3 dvec4 fvec2 fvec3 fvec4 sampler3DRect filter image1D image2D image3D imageCube iimage1D "
    "iimage2D iimage3D iimageCube uimage1D uimage2D uimage3D uimageCube image1DArray image2DArray "
    "iimage1DArray iimage2DArray uimage1DArray uimage2DArray imageBuffer iimageBuffer uimageBuffer "
    "sampler1D sampler1DShadow sampler1DArray sampler1DArrayShadow isampler1D isampler1DArray "
    "usampler1D usampler1DArray sampler2DRect sampler2DRectShadow isampler2DRect usampler2DRect "
    "samplerExternalOES image1DShadow image2DShadow samplerBuffer isamplerBuffer usamplerBuffer "
    "sampler2DMS isampler2DMS usampler2DMS "
    "sampler2DMSArray isampler2DMSArray usampler2DMSArray sizeof cast namespace using "};

// The GLSL ES 1.00 specification, section 3.6.
const Dialect glsl100{
    "glsl100", false,
    " float int bool vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 ",
    " gl_Position gl_PointSize gl_FragCoord gl_FrontFacing gl_PointCoord ",
    " attribute const uniform varying break continue do for while if else in out inout float int "
    "void bool true false lowp mediump highp precision invariant discard return mat2 mat3 mat4 "
    "vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 sampler2D samplerCube struct asm class "
    "union enum typedef template this packed goto switch default inline noinline volatile public "
    "static extern external interface flat long short double half fixed unsigned superp input "
    "output hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 fvec2 fvec3 fvec4 sampler1D sampler3D "
    "sampler1DShadow sampler2DShadow sampler2DRect sampler3DRect sampler2DRectShadow sizeof cast "
    "namespace using "};

const Dialect* findDialect(std::string_view name) {
  for (const Dialect* dialect : {&glsl300, &glsl100}) {
    if (dialect->name == name) return dialect;
  }
  return nullptr;
}

}  // namespace warpjet
