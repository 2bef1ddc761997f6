#include "emit/dialect.hpp"

namespace warpjet {

// The WebGPU Shading Language, W3C, sections 6, 16 and 17.
constinit const Dialect wgsl{
    .name = "wgsl",
    .language = ops::Language::Wgsl,
    .family = "WGSL",
    .sourceKey = "wgsl",
    .operators = "%&|^~",
    .constructors =
        " bool f32 i32 u32 vec2 vec3 vec4 vec2f vec3f vec4f vec2i vec3i vec4i vec2u vec3u vec4u "
        "mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 mat2x2f mat2x3f mat2x4f "
        "mat3x2f mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f ",
    .hasTemplates = true,
    .builtIns = " ",
    .nonFloats = " ",
    .keywords =
        " _ alias bitcast break case const const_assert continue continuing default diagnostic "
        "discard else enable false fn for if let loop override requires return struct switch "
        "true var while NULL Self abstract active alignas alignof as asm asm_fragment async "
        "attribute auto await become cast catch class co_await co_return co_yield coherent "
        "column_major common compile compile_fragment concept const_cast consteval constexpr "
        "constinit crate debugger decltype delete demote demote_to_helper do dynamic_cast enum "
        "explicit export extends extern external fallthrough filter final finally friend from "
        "fxgroup get goto groupshared highp impl implements import inline instanceof interface "
        "layout lowp macro macro_rules match mediump meta mod module move mut mutable namespace "
        "new nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null "
        "nullptr of operator package packoffset partition pass patch pixelfragment precise "
        "precision premerge priv protected pub public readonly ref regardless register "
        "reinterpret_cast require resource restrict self set shared sizeof smooth snorm static "
        "static_assert static_cast std subroutine super target template this thread_local throw "
        "trait try type typedef typeid typename typeof union unless unorm unsafe unsized use "
        "using varying virtual volatile wgsl where with writeonly yield array atomic bool f16 "
        "f32 i32 u32 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 mat2x2f "
        "mat2x3f mat2x4f mat3x2f mat3x3f mat3x4f mat4x2f mat4x3f mat4x4f ptr sampler vec2 vec3 "
        "vec4 vec2f vec3f vec4f vec2i vec3i vec4i vec2u vec3u vec4u vec2h vec3h vec4h mat2x2h "
        "mat2x3h mat2x4h mat3x2h mat3x3h mat3x4h mat4x2h mat4x3h mat4x4h sampler_comparison "
        "texture_1d texture_2d texture_2d_array texture_3d texture_cube texture_cube_array "
        "texture_depth_2d texture_depth_2d_array texture_depth_cube texture_depth_cube_array "
        "texture_depth_multisampled_2d texture_external texture_multisampled_2d "
        "texture_storage_1d texture_storage_2d texture_storage_2d_array texture_storage_3d ",
    // Includes the access modes and address spaces of declarations, as in `var<storage,
    // read_write>`.
    .functions =
        " read write read_write storage uniform workgroup private function "
        "abs acos acosh all any arrayLength asin asinh atan atan2 atanh ceil clamp cos cosh "
        "countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance "
        "dot dot4I8Packed dot4U8Packed exp exp2 extractBits faceForward firstLeadingBit "
        "firstTrailingBit floor fma fract frexp insertBits inverseSqrt ldexp length log log2 max "
        "min mix modf normalize pow quantizeToF16 radians reflect refract reverseBits round "
        "saturate select sign sin sinh smoothstep sqrt step tan tanh transpose trunc dpdx "
        "dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine fwidth fwidthCoarse fwidthFine "
        "textureDimensions textureGather textureGatherCompare textureLoad textureNumLayers "
        "textureNumLevels textureNumSamples textureSample textureSampleBaseClampToEdge "
        "textureSampleBias textureSampleCompare textureSampleCompareLevel textureSampleGrad "
        "textureSampleLevel textureStore atomicAdd atomicAnd atomicCompareExchangeWeak "
        "atomicExchange atomicLoad atomicMax atomicMin atomicOr atomicStore atomicSub atomicXor "
        "pack2x16float pack2x16snorm pack2x16unorm pack4x8snorm pack4x8unorm pack4xI8 "
        "pack4xI8Clamp pack4xU8 pack4xU8Clamp unpack2x16float unpack2x16snorm unpack2x16unorm "
        "unpack4x8snorm unpack4x8unorm unpack4xI8 unpack4xU8 storageBarrier textureBarrier "
        "workgroupBarrier workgroupUniformLoad subgroupAdd subgroupAll subgroupAnd subgroupAny "
        "subgroupBallot subgroupBroadcast subgroupBroadcastFirst subgroupElect "
        "subgroupExclusiveAdd subgroupExclusiveMul subgroupInclusiveAdd subgroupInclusiveMul "
        "subgroupMax subgroupMin subgroupMul subgroupOr subgroupShuffle subgroupShuffleDown "
        "subgroupShuffleUp subgroupShuffleXor subgroupXor quadBroadcast quadSwapDiagonal "
        "quadSwapX quadSwapY ",
    .maxNameLength = 256,
    .numbers = {"f32", "bool", "i32"},
    .vectors = {{{"vec2f", "vec3f", "vec4f"},
                 {"vec2<bool>", "vec3<bool>", "vec4<bool>"},
                 {"vec2i", "vec3i", "vec4i"}}},
    .matrices = {{{"mat2x2f", "mat2x3f", "mat2x4f"},
                  {"mat3x2f", "mat3x3f", "mat3x4f"},
                  {"mat4x2f", "mat4x3f", "mat4x4f"}}},
    .image = "texture_2d<f32>",
    .missingTypes = "",
    .numberSuffix = "f",
    .declaration = "var $1: $0",
    .declaresSeveral = false,
    .definition = "let $1 = ",
    .variable = "var $1 = ",
    .loop = "for (var $0 = 0; $0 < $1; $0++) {\n",
    .construction = "$0($1)",
    .splat = "$0($1)",
    .function = "fn $1($2) -> $0 {\n",
    .parameter = "$1: $0",
    .structure = "struct $0 {$1 }\n",
    .member = " $1: $0,",
    .imageSize = "vec2f(textureDimensions($0))",
    .texel =
        R"(fn warpjetTexel(x: f32, y: f32, image: texture_2d<f32>, width: f32, height: f32) -> vec4f {
  return textureLoad(image, vec2i(i32(x), i32(y)), 0);
}
)",
    .sampledTexel =
        R"(fn warpjetSampledTexel(x: f32, y: f32, image: texture_2d<f32>, width: f32, height: f32) -> vec4f {
  let last = vec2f(width, height) - 1.0;
  return textureLoad(image, vec2i(clamp(vec2f(x, y), vec2f(0.0), last)), 0);
}
)",
    // Allows derivatives in branches that only some pixels take. They are wrong only in pixels with
    // a neighbor that takes the other branch.
    .across = R"(@diagnostic(off, derivative_uniformity)
fn warpjetAcross(x: f32) -> f32 {
  return dpdx(x);
}
)",
    .down = R"(@diagnostic(off, derivative_uniformity)
fn warpjetDown(x: f32) -> f32 {
  return dpdy(x);
}
)"};

}  // namespace warpjet
