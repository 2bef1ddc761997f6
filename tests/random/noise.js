// Estimates how much errors of float32 size grow in an expression: evaluates it with its intermediate values changed by errors
// that a GPU may make. Derivatives of the changed function show the effect of such errors on a derivative.
import { evaluate } from './ast.js'
import { choicesAt } from './choices.js'
import { randomOf } from './generate.js'
import { plainOperations, rotationFrom, structural } from './plain.js'

/** A few units in the last place. */
const relativeError = 2 ** -22

/** Operations that only select, or whose results are exact in float32. */
const exactOperations = new Set(
  [
    'input neg abs sign floor ceil round trunc step min max clamp vecMin vecMax vecClamp',
    'lt le gt ge eq ne and or not ifElse vecIfElse swizzle column row transpose',
    'vec2 vec3 vec4 mat2 mat3 mat4 mat2Rows mat3Rows mat4Rows',
  ].flatMap((names) => names.split(' ')),
)
const isExact = ({ op, value }) =>
  op === 'number' ? Math.fround(value) === value : exactOperations.has(op)

/** Operations that add up products, whose intermediate results may be larger than the final one. */
const sums = new Set([...Object.keys(structural), 'mult', 'mix', 'vecMix'])
sums.delete('dist')
sums.delete('distance')

/** Operations whose errors do not shrink with the result: differences of exponentials, and logarithms. */
const absoluteError = 1e-6
const withAbsoluteError = new Set(['sinh', 'tanh', 'asinh', 'atanh', 'acosh', 'log', 'log2'])

/** Returns the argument `around` for `evaluate` that adds rounding errors to each operation; different ones for each sample. */
function roundingErrors(sample) {
  // Every second sample has the errors of the previous one with opposite sign, so that one of the two crosses a nearby jump.
  const random = randomOf(sample >> 1)
  const sign = sample % 2 ? -1 : 1
  const noise = () => sign * (random() < 0.5 ? -1 : 1) * (0.5 + random())
  const blur = (value) => value.map((x) => x * (1 + relativeError * noise()))

  return (node, values, compute) => {
    const value = compute(sums.has(node.op) ? values.map(blur) : values)
    if (isExact(node)) return value
    const offset = withAbsoluteError.has(node.op) ? absoluteError : 0
    return blur(value).map((x) => x + offset * noise())
  }
}

const manySamples = [0, 1, 2, 3, 4, 5, 6, 7]
const samples = [0, 1, 2, 3]

/** Returns whether an expression stays on the same sides of its kinks and jumps under rounding errors. */
export function isFirm(root, point) {
  const choices = choicesAt(root, point)
  return manySamples.every((sample) => choicesAt(root, point, roundingErrors(sample)) === choices)
}

/**
 * Returns, for each number, the max distance of `estimate(f)` from `exactValues` over a few samples of f, which is the
 * expression with rounding errors.
 */
export function roundingSpread(root, exactValues, estimate, operations) {
  const largest = exactValues.map(() => 0)
  for (const sample of samples) {
    const roundedValue = (point) =>
      evaluate(root, point, { operations, around: roundingErrors(sample) })
    estimate(roundedValue).forEach((value, i) => {
      const distance = Math.abs(value - exactValues[i])
      // NaN stays NaN.
      largest[i] = distance <= largest[i] ? largest[i] : distance
    })
  }
  return largest
}

/** The max errors of SwiftShader's functions. */
const errors = { sin: 2.5e-4, cos: 2.5e-4, asin: 1e-4, acos: 1e-4, atan: 1e-4 }

/**
 * Returns the expression as a function of a point. Of all calls of the functions in `errors`, only the one with the index `errorCall` has
 * an error. It oscillates with the argument, shifted by `phase`, so that it affects the derivative, too. Calls `count` with the number of
 * calls.
 */
function withSineError(root, errorCall, phase, count = () => {}) {
  return (point) => {
    let calls = 0
    const wave = (name) => (x, other) => {
      const value = plainOperations[name](x, other)
      return calls++ === errorCall ? value + errors[name] * Math.sin(x + phase) : value
    }
    const [sin, cos, asin, acos, atan] = Object.keys(errors).map(wave)
    const operations = { ...plainOperations, ...rotationFrom(sin, cos), asin, acos, atan }
    const value = evaluate(root, point, { operations })
    count(calls)
    return value
  }
}

/** Like `roundingSpread`, for the errors of sines and arc functions: returns the sum of their separate effects. */
export function sineSpread(root, point, exactValues, estimate) {
  let calls
  withSineError(root, -1, 0, (count) => (calls = count))(point)
  const sum = exactValues.map(() => 0)
  for (let errorCall = 0; errorCall < calls; errorCall++)
    for (const phase of [0, Math.PI / 2])
      estimate(withSineError(root, errorCall, phase)).forEach((value, i) => {
        sum[i] += Math.abs(value - exactValues[i])
      })
  return sum
}
