// Names that a sketch might give to its own functions: built-in names of each language, by the chapters of its specification, and
// words that some language may reserve.
import hljs from 'highlight.js/lib/core'
import glsl from 'highlight.js/lib/languages/glsl'

const words = (text) => text.trim().split(/\s+/)

/** Sections 8.1 to 8.6 of both GLSL ES specifications. */
const functionsOfBothGlsl = `
  radians degrees sin cos tan asin acos atan
  pow exp log exp2 log2 sqrt inversesqrt
  abs sign floor ceil fract mod min max clamp mix step smoothstep
  length distance dot cross normalize faceforward reflect refract
  matrixCompMult lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual any all not`

/** The built-in functions of each language. */
export const functions = {
  glsl100: words(`${functionsOfBothGlsl}
    texture2D texture2DProj texture2DLod texture2DProjLod textureCube textureCubeLod`),
  glsl300: words(`${functionsOfBothGlsl}
    sinh cosh tanh asinh acosh atanh trunc round roundEven modf isnan isinf
    floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat
    packSnorm2x16 unpackSnorm2x16 packUnorm2x16 unpackUnorm2x16 packHalf2x16 unpackHalf2x16
    outerProduct transpose determinant inverse
    textureSize texture textureProj textureLod textureOffset texelFetch texelFetchOffset textureProjOffset
    textureLodOffset textureProjLod textureProjLodOffset textureGrad textureGradOffset textureProjGrad
    textureProjGradOffset dFdx dFdy fwidth`),
  wgsl: words(`
    all any select arrayLength
    abs acos acosh asin asinh atan atanh atan2 ceil clamp cos cosh cross degrees determinant distance dot exp exp2
    faceForward floor fma fract frexp inverseSqrt ldexp length log log2 max min mix modf normalize pow quantizeToF16
    radians reflect refract round saturate sign sin sinh smoothstep sqrt step tan tanh transpose trunc
    countLeadingZeros countOneBits countTrailingZeros extractBits insertBits reverseBits firstLeadingBit
    firstTrailingBit dot4U8Packed dot4I8Packed
    dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine fwidth fwidthCoarse fwidthFine
    textureDimensions textureGather textureGatherCompare textureLoad textureNumLayers textureNumLevels
    textureNumSamples textureSample textureSampleBias textureSampleCompare textureSampleCompareLevel
    textureSampleGrad textureSampleLevel textureSampleBaseClampToEdge textureStore
    atomicLoad atomicStore atomicAdd atomicSub atomicMax atomicMin atomicAnd atomicOr atomicXor atomicExchange
    pack4x8snorm unpack4x8snorm pack2x16float unpack2x16float workgroupBarrier storageBarrier`),
}

const { keywords } = (hljs.registerLanguage('glsl', glsl), hljs.getLanguage('glsl'))

/** Names to try: built-in functions, names of desktop GLSL, and some that only look reserved. */
export const candidates = [
  ...new Set([
    ...Object.values(functions).flat(),
    ...Object.values(keywords).flatMap((group) => (Array.isArray(group) ? group : words(group))),
    ...words(`
      main f i x y z w t0 t1 result part0 seed image inputs outputs
      warpjetHash warpjetRemainder warpjetNoise2 warpjetTexel warpjetNoise2Gradient
      vec3f vec3h mat3x3f f32 i32 u32 f16 fn var let array ptr sampler texture_2d read write read_write function private
      storage workgroup uniform perspective linear rgba8unorm position vertex_index builtin group binding vertex
      fragment compute workgroup_size enable struct saturate ddx lerp frac noise rand hash map
      texture2DLodEXT textureCubeLodEXT texture2DGradEXT gl_x webgl_x a__b`),
  ]),
]
