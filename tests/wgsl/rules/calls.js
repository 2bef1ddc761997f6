// Valid and invalid calls of built-in functions.
/**
 * Functions of one argument. Those of two are `pairs`, of three `triples`. Each is called with several lists of operands, most of them
 * wrong.
 */
const functions =
  `abs acos acosh asin asinh atan atanh ceil cos cosh countLeadingZeros countOneBits countTrailingZeros degrees exp
  exp2 firstLeadingBit firstTrailingBit floor fract frexp inverseSqrt length log log2 modf normalize quantizeToF16 radians
  reverseBits round saturate sign sin sinh sqrt tan tanh transpose determinant trunc all any pack4x8snorm pack2x16float
  unpack4x8unorm unpack2x16float pack4xI8 pack4xU8 unpack4xI8 f32 i32 u32 bool vec2 vec3f vec3i mat2x2 mat3x3f array noise inverse
  isNan`
    .trim()
    .split(/\s+/)
const pairs =
  `atan2 cross distance dot ldexp max min pow reflect step vec2 vec3 vec4f mat2x2 array dot4I8Packed`.split(
    ' ',
  )
const triples =
  `clamp extractBits faceForward fma mix refract select smoothstep vec3 vec4 mat3x3 array`.split(
    ' ',
  )
const someOperands = [
  '0.5',
  '1',
  '2i',
  '2u',
  'true',
  'p',
  'vec2f(1)',
  'vec3i(1)',
  'vec4u(1)',
  'p.x',
  'mat3x3f()',
]
export const calls = [
  ...functions.flatMap((name) => ['', ...someOperands].map((operand) => `${name}(${operand})`)),
  ...pairs.flatMap((name) =>
    someOperands.flatMap((a) => someOperands.map((b) => `${name}(${a}, ${b})`)),
  ),
  ...triples.flatMap((name) =>
    someOperands.flatMap((a) =>
      ['0.5', '1', 'p', 'true', '2u'].map((b) => `${name}(${a}, ${a}, ${b})`),
    ),
  ),
]
