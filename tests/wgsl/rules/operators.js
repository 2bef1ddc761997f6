// Operators with one operand or two, of each pair of types.
import { body } from './sources.js'

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
const declared = 'struct S { x: f32 }'
export const operators = binary.flatMap((symbol) =>
  operands.flatMap((left) =>
    operands.map((right) => [
      `operator: ${left} ${symbol} ${right}`,
      body(`var s: S; var a: array<f32, 3>; _ = (${left}) ${symbol} (${right});`, declared),
    ]),
  ),
)
export const unary = ['-', '!', '~', '&', '*'].flatMap((symbol) =>
  operands.map((operand) => [
    `operator: ${symbol}${operand}`,
    body(`var s: S; var a: array<f32, 3>; _ = ${symbol}(${operand});`, declared),
  ]),
)
