// Evaluates random cases on a GPU, many in one shader, and compares them with plain numbers, within the effects of float32 errors.
import {
  callbackText,
  components,
  evaluate,
  inputs,
  inputsOf,
  singleResult,
  valueResult,
} from './ast.js'
import { callbackOf, differentiate, kindOf, secondResults } from './check.js'
import { slopeOf } from './differences.js'
import { randomOf } from './generate.js'
import { isFirm, roundingSpread, sineSpread } from './noise.js'
import { dimension, isMatrix, sizeOf } from './shapes.js'

/** The factor of rounding errors, since they are estimated from a few samples. */
const safety = 8
/** The factor of the accumulated errors of sines, since these do not simply add up. */
const nonlinear = 1.5
/** The tolerance for the rounding of the result. */
const rounding = 1e-5
/** The max uncertainty of a number that is compared, relative to its size if above 1. */
const maxUncertain = 0.05

/** Returns the results to check: the value, a first derivative for every third seed, and a second one for every ninth. */
export function gpuResults({ seed, root }) {
  const random = randomOf(seed)
  const usedInputs = inputsOf(root)
  const usable = root.shape === 'bool' ? [] : components.filter(({ name }) => usedInputs.has(name))
  const first = usable[Math.floor(usable.length * random())]
  const results = [valueResult(root)]
  if (first && seed % 3 === 0) results.push(singleResult(root, first))
  if (seed % 9 === 1) results.push(...secondResults(root, random, 1))
  return results.map((result) => ({ ...result, name: `s${seed}_${result.name}` }))
}

/** Returns the program of some cases for `pipelines.run`. `compile` is that of warpjet, or a wrong one. */
export function programOf(cases, target, compile) {
  const compiled = cases.map((test) =>
    compile(callbackOf(callbackText(test.root, gpuResults(test))), { target }),
  )
  return {
    code: compiled.map(({ code }) => code).join('\n'),
    declarations: [...new Set(compiled.map(({ declarations }) => declarations))].join('\n'),
    inputs: inputs.map(toVariable),
    outputs: cases.flatMap((test) => gpuResults(test).map(toVariable)),
  }
}
const toVariable = ({ name, shape }) => ({
  name,
  shape: isMatrix(shape) || shape === 'bool' ? shape : dimension(shape),
})

/** Converts a point for `pipelines.run`. */
export const toFloats = (point) => inputs.flatMap(({ name }) => point[name])

/**
 * Returns what we expect from a GPU at a point: for each number of each result { value, tolerance }, or null if it is too uncertain.
 */
export function gpuExpected(test, point) {
  const { root } = test
  const isComparable = isFirm(root, point)
  return gpuResults(test).map((result) => {
    const { entries } = result
    if (!isComparable) return Array(sizeOf(root.shape)).fill(null)
    const estimate = (f) => (entries ? slopeOf(f, point, entries[0].by) : f(point))
    const numbers = entries
      ? differentiate(root, result, point)
      : evaluate(root, point).map((value) => ({ value, error: 0 }))
    const values = numbers.map(({ value }) => value)
    const uncertain = roundingSpread(root, values, estimate)
    const waves = sineSpread(root, point, values, estimate)
    return numbers.map(({ value, error }, i) => {
      const scale = Math.max(1, Math.abs(value))
      const tolerance = safety * uncertain[i] + nonlinear * waves[i] + rounding * scale + error
      return tolerance <= maxUncertain * scale ? { value, tolerance } : null
    })
  })
}

/**
 * Compares the GPU's results for the cases of a program at each point; returns { failures, counts }. `expected` has the results of
 * `gpuExpected` by case and by point.
 */
export function compareGpu(cases, results, expected) {
  const counts = { compared: 0, total: 0 }
  const failures = []
  let start = 0
  for (const [c, test] of cases.entries()) {
    let failure
    for (const [r, result] of gpuResults(test).entries()) {
      const size = sizeOf(result.shape)
      for (const [p, point] of test.points.entries()) {
        const got = Array.from(results[p].slice(start, start + size))
        const wanted = expected[c][p][r]
        counts.total += size
        counts.compared += wanted.filter(Boolean).length
        const isNear = (number, i) => !number || Math.abs(got[i] - number.value) <= number.tolerance
        if (!wanted.every(isNear))
          failure ??= {
            kind: kindOf(result),
            point,
            result,
            got,
            expected: wanted.map((number) => number?.value),
          }
      }
      start += size
    }
    if (failure) failures.push({ test, failure })
  }
  return { failures, counts }
}
