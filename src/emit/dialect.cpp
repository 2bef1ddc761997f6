#include "emit/dialect.hpp"

namespace warpjet {

// The GLSL ES 3.00 specification, sections 3.8 and 8.
const Dialect glsl300{
    .name = "glsl300",
    .language = ops::Language::Glsl300,
    .family = "GLSL",
    .operators = "%&|^~?:",
    .numberSuffix = "",
    .declaresWithVar = false,
    .hasRectangularMatrices = true,
    .constructors =
        " float int uint bool vec2 vec3 vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 "
        "mat2 "
        "mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 ",
    .builtIns =
        " gl_VertexID gl_InstanceID gl_Position gl_PointSize gl_FragCoord gl_FrontFacing "
        "gl_PointCoord ",
    .otherTypes = " gl_VertexID gl_InstanceID gl_FrontFacing ",
    .keywords =
        " const uniform layout centroid flat smooth break continue do for while switch case "
        "default if "
        "else in out inout float int void bool true false invariant discard return mat2 mat3 mat4 "
        "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 vec2 vec3 vec4 ivec2 ivec3 "
        "ivec4 bvec2 bvec3 bvec4 uint uvec2 uvec3 uvec4 lowp mediump highp precision sampler2D "
        "sampler3D samplerCube sampler2DShadow samplerCubeShadow sampler2DArray "
        "sampler2DArrayShadow "
        "isampler2D isampler3D isamplerCube isampler2DArray usampler2D usampler3D usamplerCube "
        "usampler2DArray struct attribute varying coherent volatile restrict readonly writeonly "
        "resource atomic_uint noperspective patch sample subroutine common partition active asm "
        "class "
        "union enum typedef template this goto inline noinline volatile public static extern "
        "external "
        "interface long short double half fixed unsigned superp input output hvec2 hvec3 hvec4 "
        "dvec2 "
        "dvec3 dvec4 fvec2 fvec3 fvec4 sampler3DRect filter image1D image2D image3D imageCube "
        "iimage1D "
        "iimage2D iimage3D iimageCube uimage1D uimage2D uimage3D uimageCube image1DArray "
        "image2DArray "
        "iimage1DArray iimage2DArray uimage1DArray uimage2DArray imageBuffer iimageBuffer "
        "uimageBuffer "
        "sampler1D sampler1DShadow sampler1DArray sampler1DArrayShadow isampler1D isampler1DArray "
        "usampler1D usampler1DArray sampler2DRect sampler2DRectShadow isampler2DRect "
        "usampler2DRect "
        "samplerExternalOES image1DShadow image2DShadow samplerBuffer isamplerBuffer "
        "usamplerBuffer "
        "sampler2DMS isampler2DMS usampler2DMS "
        "sampler2DMSArray isampler2DMSArray usampler2DMSArray sizeof cast namespace using ",
    .functions =
        " radians degrees sin cos tan asin acos atan pow exp log exp2 log2 sqrt inversesqrt "
        "abs sign floor ceil fract mod min max clamp mix step smoothstep length distance dot "
        "cross normalize faceforward reflect refract matrixCompMult lessThan lessThanEqual "
        "greaterThan greaterThanEqual equal notEqual any all not sinh cosh tanh asinh acosh "
        "atanh trunc round roundEven modf isnan isinf floatBitsToInt floatBitsToUint "
        "intBitsToFloat uintBitsToFloat packSnorm2x16 unpackSnorm2x16 packUnorm2x16 "
        "unpackUnorm2x16 packHalf2x16 unpackHalf2x16 outerProduct transpose determinant "
        "inverse textureSize texture textureProj textureLod textureOffset texelFetch "
        "texelFetchOffset textureProjOffset textureLodOffset textureProjLod "
        "textureProjLodOffset textureGrad textureGradOffset textureProjGrad "
        "textureProjGradOffset dFdx dFdy fwidth "};

// The GLSL ES 1.00 specification, sections 3.6 and 8, and its extensions in WebGL.
const Dialect glsl100{
    .name = "glsl100",
    .language = ops::Language::Glsl100,
    .family = "GLSL",
    .operators = "?:",
    .numberSuffix = "",
    .declaresWithVar = false,
    .hasRectangularMatrices = false,
    .constructors =
        " float int bool vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 ",
    .builtIns = " gl_Position gl_PointSize gl_FragCoord gl_FrontFacing gl_PointCoord ",
    .otherTypes = " gl_FrontFacing ",
    .keywords =
        " attribute const uniform varying break continue do for while if else in out inout float "
        "int "
        "void bool true false lowp mediump highp precision invariant discard return mat2 mat3 mat4 "
        "vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 sampler2D samplerCube struct asm class "
        "union enum typedef template this packed goto switch default inline noinline volatile "
        "public "
        "static extern external interface flat long short double half fixed unsigned superp input "
        "output hvec2 hvec3 hvec4 dvec2 dvec3 dvec4 fvec2 fvec3 fvec4 sampler1D sampler3D "
        "sampler1DShadow sampler2DShadow sampler2DRect sampler3DRect sampler2DRectShadow sizeof "
        "cast "
        "namespace using ",
    .functions =
        " radians degrees sin cos tan asin acos atan pow exp log exp2 log2 sqrt inversesqrt "
        "abs sign floor ceil fract mod min max clamp mix step smoothstep length distance dot "
        "cross normalize faceforward reflect refract matrixCompMult lessThan lessThanEqual "
        "greaterThan greaterThanEqual equal notEqual any all not texture2D texture2DProj "
        "texture2DLod texture2DProjLod textureCube textureCubeLod texture2DLodEXT "
        "texture2DProjLodEXT textureCubeLodEXT texture2DGradEXT texture2DProjGradEXT "
        "textureCubeGradEXT dFdx dFdy fwidth "};

// The WebGPU Shading Language, W3C, sections 6, 16 and 17.
const Dialect wgsl{
    .name = "wgsl",
    .language = ops::Language::Wgsl,
    .family = "WGSL",
    .operators = "%&|^~",
    .numberSuffix = "f",
    .declaresWithVar = true,
    .hasRectangularMatrices = true,
    .constructors =
        " bool f32 i32 u32 vec2 vec3 vec4 vec2f vec3f vec4f vec2i vec3i vec4i vec2u vec3u vec4u "
        "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 mat2x2f mat2x3f mat2x4f "
        "mat3x2f mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f ",
    .builtIns = " ",
    .otherTypes = " ",
    .keywords =
        " _ alias bitcast break case const const_assert continue continuing default diagnostic "
        "discard else enable false fn for if let loop override requires return struct switch true "
        "var while NULL Self abstract active alignas alignof as asm asm_fragment async attribute "
        "auto await become cast catch class co_await co_return co_yield coherent column_major "
        "common compile compile_fragment concept const_cast consteval constexpr constinit crate "
        "debugger decltype delete demote demote_to_helper do dynamic_cast enum explicit export "
        "extends extern external fallthrough filter final finally friend from fxgroup get goto "
        "groupshared highp impl implements import inline instanceof interface layout lowp macro "
        "macro_rules match mediump meta mod module move mut mutable namespace new nil noexcept "
        "noinline nointerpolation non_coherent noncoherent noperspective null nullptr of operator "
        "package packoffset partition pass patch pixelfragment precise precision premerge priv "
        "protected pub public readonly ref regardless register reinterpret_cast require resource "
        "restrict self set shared sizeof smooth snorm static static_assert static_cast std "
        "subroutine super target template this thread_local throw trait try type typedef typeid "
        "typename typeof union unless unorm unsafe unsized use using varying virtual volatile wgsl "
        "where with writeonly yield array atomic bool f16 f32 i32 u32 mat2x2 mat2x3 mat2x4 mat3x2 "
        "mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 mat2x2f mat2x3f mat2x4f mat3x2f mat3x3f mat3x4f "
        "mat4x2f "
        "mat4x3f mat4x4f ptr sampler vec2 vec3 vec4 vec2f vec3f vec4f vec2i vec3i vec4i vec2u "
        "vec3u "
        "vec4u vec2h "
        "vec3h vec4h mat2x2h mat2x3h mat2x4h mat3x2h mat3x3h mat3x4h mat4x2h mat4x3h mat4x4h "
        "sampler_comparison texture_1d texture_2d texture_2d_array texture_3d texture_cube "
        "texture_cube_array texture_depth_2d texture_depth_2d_array texture_depth_cube "
        "texture_depth_cube_array texture_depth_multisampled_2d texture_external "
        "texture_multisampled_2d texture_storage_1d texture_storage_2d "
        "texture_storage_2d_array texture_storage_3d ",
    .functions =
        " abs acos acosh all any arrayLength asin asinh atan atan2 atanh ceil clamp cos cosh "
        "countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance "
        "dot dot4I8Packed dot4U8Packed exp exp2 extractBits faceForward firstLeadingBit "
        "firstTrailingBit floor fma fract frexp insertBits inverseSqrt ldexp length log log2 "
        "max min mix modf normalize pow quantizeToF16 radians reflect refract reverseBits "
        "round saturate select sign sin sinh smoothstep sqrt step tan tanh transpose trunc "
        "dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine fwidth fwidthCoarse fwidthFine "
        "textureDimensions textureGather textureGatherCompare textureLoad textureNumLayers "
        "textureNumLevels textureNumSamples textureSample textureSampleBaseClampToEdge "
        "textureSampleBias textureSampleCompare textureSampleCompareLevel textureSampleGrad "
        "textureSampleLevel textureStore atomicAdd atomicAnd atomicCompareExchangeWeak "
        "atomicExchange atomicLoad atomicMax atomicMin atomicOr atomicStore atomicSub "
        "atomicXor pack2x16float pack2x16snorm pack2x16unorm pack4x8snorm pack4x8unorm "
        "pack4xI8 pack4xI8Clamp pack4xU8 pack4xU8Clamp unpack2x16float unpack2x16snorm "
        "unpack2x16unorm unpack4x8snorm unpack4x8unorm unpack4xI8 unpack4xU8 storageBarrier "
        "textureBarrier workgroupBarrier workgroupUniformLoad subgroupAdd subgroupAll "
        "subgroupAnd subgroupAny subgroupBallot subgroupBroadcast subgroupBroadcastFirst "
        "subgroupElect subgroupExclusiveAdd subgroupExclusiveMul subgroupInclusiveAdd "
        "subgroupInclusiveMul subgroupMax subgroupMin subgroupMul subgroupOr subgroupShuffle "
        "subgroupShuffleDown subgroupShuffleUp subgroupShuffleXor subgroupXor quadBroadcast "
        "quadSwapDiagonal quadSwapX quadSwapY "};

const Dialect* findDialect(std::string_view name) {
  for (const Dialect* dialect : {&glsl300, &glsl100, &wgsl}) {
    if (dialect->name == name) return dialect;
  }
  return nullptr;
}

std::string Dialect::typeName(ops::Type type, Shape shape) const {
  const bool isFloat = type == ops::Type::Float, isWgsl = language == ops::Language::Wgsl;
  if (shape == oneImage) return isWgsl ? "texture_2d<f32>" : "highp sampler2D";
  if (shape.isNumber()) return isFloat ? (isWgsl ? "f32" : "float") : "bool";
  const std::string rows = std::to_string(shape.rows), columns = std::to_string(shape.columns);
  if (shape.isMatrix()) {
    return "mat" + columns + (shape.isSquare() && !isWgsl ? "" : 'x' + rows) + (isWgsl ? "f" : "");
  }
  if (isWgsl) return "vec" + rows + (isFloat ? "f" : "<bool>");
  return (isFloat ? "vec" : "bvec") + rows;
}

std::string Dialect::declaration(const std::string& type, const std::string& variable) const {
  return declaresWithVar ? "var " + variable + ": " + type : type + ' ' + variable;
}

std::string Dialect::definition(const std::string& type, const std::string& variable) const {
  return (declaresWithVar ? "let" : type) + ' ' + variable + " = ";
}

}  // namespace warpjet
