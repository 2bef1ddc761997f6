// Runs the test case of an operation on any pipeline, and measures the errors of the value and of its derivatives with respect to every
// number of every operand. The case's function `reference` alone determines the expected results: expected derivatives are its finite
// differences.
import { setImmediate } from 'node:timers/promises'
import { sizeOf } from '../support/browser/pipelines/text.js'
import { seededRandom } from '../warps/random.js'
import { jacobian } from './numeric.js'

/** A few points are lost to kinks; 200 must remain for each derivative. */
const pointCount = 240

/** Returns the same points for a case in every run; float32 numbers, so that all pipelines get identical input. */
function samplePoints({ title, inputs, domains, adjust }) {
  const seed = [...title].reduce((hash, letter) => (hash * 31 + letter.charCodeAt(0)) % 1e6, 1)
  const random = seededRandom(seed + 1)
  return Array.from({ length: pointCount }, () => {
    const operands = inputs.map(({ shape }, i) =>
      Array.from({ length: sizeOf(shape) }, () => (domains[i] ?? domains.at(-1))(random)),
    )
    return adjust(operands, random).flat().map(Math.fround)
  })
}

/** Splits the numbers of a point into operands. */
function operandsOf({ inputs }, point) {
  let next = 0
  return inputs.map(({ shape }) => point.slice(next, (next += sizeOf(shape))))
}

const pointCache = new Map()
const expectationCache = new Map()

function pointsOf(operation) {
  if (!pointCache.has(operation)) pointCache.set(operation, samplePoints(operation))
  return pointCache.get(operation)
}

/**
 * Returns the expected results at each point, [{ point, value, slopes, sensitivity }]; slopes have the layout of `jacobian`, and
 * the sensitivities of the value and its derivatives have a number for each component.
 */
function expectations(operation) {
  if (!expectationCache.has(operation)) {
    const f = (point) => operation.reference(...operandsOf(operation, point))
    const expected = pointsOf(operation).map((point) => {
      const value = f(point)
      const sensitivity = (kind) => {
        const sensitivities = operation.sensitivity[kind]?.(...operandsOf(operation, point)) ?? [1]
        return value.map((_, k) => sensitivities[k % sensitivities.length])
      }
      return {
        point,
        value,
        slopes: jacobian(f, point),
        sensitivity: { value: sensitivity('value'), derivative: sensitivity('derivative') },
      }
    })
    expectationCache.set(operation, expected)
  }
  return expectationCache.get(operation)
}

/** Returns |got - expected| / max(1, |expected|) / sensitivity; infinite for NaN. */
export function errorOf(got, expected, sensitivity) {
  const error = Math.abs(got - expected) / Math.max(1, Math.abs(expected)) / sensitivity
  return Number.isNaN(error) ? Infinity : error
}

/**
 * Runs a case; `run(points)` must return all resulting numbers at each point. Returns {
 * - `value`, `derivative`: the max errors, { error, at, got, expected, by }, each divided by the sensitivity;
 * - `points`;
 * - `derivatives`: the number of derivatives that were compared; `excluded`: the number of those that were not, since the differences
 *   show a kink;
 * - `fewest`: the min number of points at which one of the partial derivatives was compared }.
 */
export async function measure(operation, run) {
  const [results, expected] = await Promise.all([
    run(pointsOf(operation)),
    // Yields, so that a GPU can process the points meanwhile.
    setImmediate().then(() => expectations(operation)),
  ])
  const worst = { value: { error: 0 }, derivative: { error: 0 } }
  const raise = (kind, measured) => {
    if (!(measured.error <= worst[kind].error)) worst[kind] = measured
  }
  const size = expected[0].value.length
  const compared = expected[0].slopes.map(() => Array(size).fill(0))

  expected.forEach(({ point, value, slopes, sensitivity }, i) => {
    value.forEach((x, k) => {
      const got = results[i][k]
      raise('value', { error: errorOf(got, x, sensitivity.value[k]), at: point, got, expected: x })
    })
    slopes.forEach((row, by) =>
      row.forEach((estimate, k) => {
        if (!estimate) return
        compared[by][k]++
        const got = results[i][size * (by + 1) + k]
        const error = errorOf(got, estimate.slope, sensitivity.derivative[k])
        raise('derivative', { error, at: point, got, expected: estimate.slope, by })
      }),
    )
  })
  const derivatives = compared.flat().reduce((sum, count) => sum + count, 0)
  return {
    ...worst,
    points: expected.length,
    derivatives,
    excluded: compared.flat().length * expected.length - derivatives,
    fewest: Math.min(...compared.flat()),
  }
}
