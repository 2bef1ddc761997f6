// web/docs/plots.md: each operation on numbers with a plot of its value and derivative, the text that comes of both, and a line
// that runs; formulas.mjs has the formulas. The site draws the plots (web/site/plot.js) from what warpjet computes.
import { formulaText } from './formulas.mjs'

/** How the operation is called for its plot, and from where to where; x alone from -3 to 3 unless named. */
const calls = {
  add: ['x.add(1)'],
  sub: ['x.sub(1)'],
  mult: ['x.mult(2)'],
  div: ['glsl.div(1, x)'],
  pow: ['x.pow(3)', -1.5, 1.5],
  sqrt: ['x.sqrt()', 0, 4],
  inversesqrt: ['x.inversesqrt()', 0.05, 4],
  exp: ['x.exp()', -3, 1.5],
  exp2: ['x.exp2()', -3, 2],
  log: ['x.log()', 0.05, 4],
  log2: ['x.log2()', 0.05, 4],
  tan: ['x.tan()', -4, 4],
  asin: ['x.asin()', -1, 1],
  acos: ['x.acos()', -1, 1],
  acosh: ['x.acosh()', 1, 5],
  atanh: ['x.atanh()', -1, 1],
  sinh: ['x.sinh()', -2, 2],
  cosh: ['x.cosh()', -2, 2],
  radians: ['x.radians()', -180, 180],
  mod: ['x.mod(1.5)'],
  min: ['x.min(1)'],
  max: ['x.max(1)'],
  clamp: ['x.clamp(-1, 1)'],
  mix: ['glsl.mix(-1, 2, x)', -0.5, 1.5],
  step: ['glsl.step(0.5, x)'],
  smoothstep: ['glsl.smoothstep(-1, 1, x)', -2, 2],
  lt: ['x.lt(1)'],
  le: ['x.le(1)'],
  gt: ['x.gt(1)'],
  ge: ['x.ge(1)'],
  eq: ['x.floor().eq(1)'],
  ne: ['x.floor().ne(1)'],
  and: ['x.gt(-1).and(x.lt(1))'],
  or: ['x.lt(-1).or(x.gt(1))'],
  not: ['x.lt(1).not()'],
  ifElse: ['x.lt(0).ifElse(x.neg(), x.mult(x))'],
}
/** Of the two operations of the name `atan`, the second. */
const atan2 = ['glsl.atan(x, -1)', -4, 4]

/** What the derivative is where there is none. */
const kinks = {
  abs: 'At 0 the derivative is 0.',
  sign: 'The derivative is 0 everywhere, at the step too.',
  floor: 'The derivative is 0 everywhere, at the steps too.',
  ceil: 'The derivative is 0 everywhere, at the steps too.',
  round: 'The derivative is 0 everywhere, at the steps too.',
  trunc: 'The derivative is 0 everywhere, at the steps too.',
  step: 'The derivative is 0 everywhere, at the edge too.',
  fract: 'The derivative is 1 everywhere, at the jumps too.',
  mod: 'The derivative by `x` is 1 everywhere, by the divisor -floor(x / divisor).',
  min: 'The derivative is that of the operand whose value is taken, of the first one where they are equal.',
  max: 'The derivative is that of the operand whose value is taken, of the first one where they are equal.',
  clamp: 'The derivative is that of the operand whose value is taken, bounds included.',
  ...Object.fromEntries(
    ['lt', 'le', 'gt', 'ge', 'eq', 'ne', 'and', 'or', 'not'].map((name) => [
      name,
      'As a number it is 1 or 0, and its derivative 0 everywhere, at the step too.',
    ]),
  ),
  ifElse:
    'The derivative is that of the value that is taken; a jump between the two counts for nothing.',
  asin: 'At -1 and 1 the derivative counts as 0.',
  acos: 'At -1 and 1 the derivative counts as 0.',
  acosh: 'At 1 the derivative counts as 0.',
  log: 'At 0 value and derivative are infinite.',
  log2: 'At 0 value and derivative are infinite.',
  inversesqrt: 'At 0 value and derivative are infinite.',
  atanh: 'At -1 and 1 value and derivative are infinite.',
  div: 'At 0 value and derivative are infinite.',
}

const isNumeric = ({ kinds, result }) =>
  [...kinds, result].every((kind) => kind === 'number or vector')

/** The plot of a call, and a warp by it. */
export const lineText = (call, from, to) => `<!-- plot ${call} from ${from} to ${to} -->

<!-- prettier-ignore -->
\`\`\`js
createWarp(({ glsl, position }) => {
  const x = position.y().add(1).mult(${(to - from) / 2})${from ? `.add(${from})` : ''}
  const value = ${call}
  return glsl.vec3(value.mult(0.1).clamp(-1, 1), 0, 0)
})
\`\`\`
`

function section(operation, index, all) {
  const { name, operands, meaning } = operation
  const isSecond = all.findIndex((other) => other.name === name) < index
  const title = isSecond ? `${name}(y, x)` : name
  const [call, from = -3, to = 3] = isSecond ? atan2 : (calls[name] ?? [`x.${name}()`])
  if (!call.includes('x') || (operands.length > 1 && !calls[name] && !isSecond))
    throw new Error(`.scripts/reference/plots.mjs lacks a call of ${name}.`)
  const sentences = [/[.!]$/.test(meaning) ? meaning : `${meaning}.`]
  if (kinks[name] && !isSecond) sentences.push(kinks[name])
  return `### ${title}

${sentences.join(' ')}

${formulaText(title, operands)}

${lineText(call, from, to)}`
}

export function plotsText({ operations, headings }) {
  const shown = operations.filter(isNumeric)
  const groups = headings
    .map((heading) => {
      const own = shown.filter((operation) => operation.heading === heading)
      return own.length && `## ${heading}\n\n${own.map(section).join('\n')}`
    })
    .filter(Boolean)
  return `<!-- Written by \`npm run reference\`; the operations come from src/ops/documentation.hpp and src/builder/compositions.hpp. -->

# Operations, plotted

Every operation on numbers, with what it computes and its derivative by each operand, as exact as it stands here. On the site each has
a plot of both by x, and beside it the text that a shader gets for them. “Run” moves a ball sideways by it, from its top to its bottom.
[Vectors, matrices and noise](plots-vectors.md) have a page of their own; here are [all operations in short](operations.md), and
[how exact each is](derivatives.md) was measured.

${groups.join('\n')}`
}
