// Unary operators with operands of each type, and binary operators with operands of each pair of types.
import { withBody } from './sources.js'

/** One operand of each type. */
const operands = [
  '1',
  '1.5',
  '2i',
  '2u',
  '2f',
  'true',
  'p',
  'p.x',
  'vec2f(1)',
  'vec3i(p)',
  'vec3u(1)',
  'vec3(1)',
  'vec3(0.5)',
  'p < vec3f()',
  'mat3x3f()',
  'mat2x3f()',
  'i32(p.x)',
  'u32(p.x)',
  'p.x > 0',
  's',
  'a',
]
const binary = ['+', '*', '%', '<', '==', '&', '^', '<<', '&&']
const structure = 'struct S { x: f32 }'
export const operators = binary.flatMap((symbol) =>
  operands.flatMap((left) =>
    operands.map((right) => [
      `operator: ${left} ${symbol} ${right}`,
      withBody(`var s: S; var a: array<f32, 3>; _ = (${left}) ${symbol} (${right});`, structure),
    ]),
  ),
)
export const unary = ['-', '!', '~', '&', '*'].flatMap((symbol) =>
  operands.map((operand) => [
    `operator: ${symbol}${operand}`,
    withBody(`var s: S; var a: array<f32, 3>; _ = ${symbol}(${operand});`, structure),
  ]),
)
