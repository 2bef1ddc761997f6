// How much errors of float32 size grow on their way through an expression: it is evaluated with its intermediate values
// changed by errors that a GPU may make. Derivatives of the changed function show what such errors do to a derivative.
import { evaluate } from './ast.js'
import { choicesAt } from './choices.js'
import { randomOf } from './generate.js'
import { plainOperations, structural, turning } from './plain.js'

/** Some units in the last place. */
const relative = 2 ** -22

/** These only choose, or come to numbers that float32 has. */
const exact = new Set(
  [
    'input neg abs sign floor ceil round trunc step min max clamp vecMin vecMax vecClamp',
    'lt le gt ge eq ne and or not ifElse vecIfElse swizzle column row transpose',
    'vec2 vec3 vec4 mat2 mat3 mat4 mat2Rows mat3Rows mat4Rows',
  ].flatMap((names) => names.split(' ')),
)
const isExact = ({ op, value }) => (op === 'number' ? Math.fround(value) === value : exact.has(op))

/** Sums of products, in which intermediate results may be larger than the last one. */
const sums = new Set([...Object.keys(structural), 'mult', 'mix', 'vecMix'])
sums.delete('dist')
sums.delete('distance')

/** Errors that do not shrink with the result: of differences of exponentials, and of logarithms. */
const absolute = 1e-6
const withAbsolute = new Set(['sinh', 'tanh', 'asinh', 'atanh', 'acosh', 'log', 'log2'])

/** Rounding errors for one evaluation, as `evaluate` takes them; each sample has others. */
function rounding(sample) {
  // Each second sample has the errors of the one before it the other way round: one of both goes over the edge of a jump.
  const random = randomOf(sample >> 1)
  const sign = sample % 2 ? -1 : 1
  const noise = () => sign * (random() < 0.5 ? -1 : 1) * (0.5 + random())
  const blur = (value) => value.map((x) => x * (1 + relative * noise()))

  return (node, values, compute) => {
    const value = compute(sums.has(node.op) ? values.map(blur) : values)
    if (isExact(node)) return value
    const offset = withAbsolute.has(node.op) ? absolute : 0
    return blur(value).map((x) => x + offset * noise())
  }
}

const manySamples = [0, 1, 2, 3, 4, 5, 6, 7]
const samples = [0, 1, 2, 3]

/** Whether rounding errors leave an expression on the same sides of its kinks and jumps. */
export function isFirm(root, point) {
  const choices = choicesAt(root, point)
  return manySamples.every((sample) => choicesAt(root, point, rounding(sample)) === choices)
}

/**
 * How far `estimate(f)` goes from `exactly`, for each number of it, if f is the expression with rounding errors: the most in a few
 * tries.
 */
export function roundingSpread(root, exactly, estimate, operations) {
  const largest = exactly.map(() => 0)
  for (const sample of samples) {
    const rounded = (point) => evaluate(root, point, { operations, around: rounding(sample) })
    estimate(rounded).forEach((value, i) => {
      const distance = Math.abs(value - exactly[i])
      // NaN stays.
      largest[i] = distance <= largest[i] ? largest[i] : distance
    })
  }
  return largest
}

/** How far SwiftShader's functions are off. */
const errors = { sin: 2.5e-4, cos: 2.5e-4, asin: 1e-4, acos: 1e-4, atan: 1e-4 }

/**
 * The function of a point, with an error in the call number `source` of those functions alone. It goes up and down with the
 * argument, so that it reaches the derivative; `phase` says where. `count` hears the number of calls.
 */
function wavy(root, source, phase, count = () => {}) {
  return (point) => {
    let calls = 0
    const wave = (name) => (x, other) => {
      const value = plainOperations[name](x, other)
      return calls++ === source ? value + errors[name] * Math.sin(x + phase) : value
    }
    const [sin, cos, asin, acos, atan] = Object.keys(errors).map(wave)
    const operations = { ...plainOperations, ...turning(sin, cos), asin, acos, atan }
    const value = evaluate(root, point, { operations })
    count(calls)
    return value
  }
}

/** The same for the errors of sines and arcs: at most the sum of what each of them does alone. */
export function sineSpread(root, point, exactly, estimate) {
  let calls
  wavy(root, -1, 0, (count) => (calls = count))(point)
  const sum = exactly.map(() => 0)
  for (let source = 0; source < calls; source++)
    for (const phase of [0, Math.PI / 2])
      estimate(wavy(root, source, phase)).forEach((value, i) => {
        sum[i] += Math.abs(value - exactly[i])
      })
  return sum
}
