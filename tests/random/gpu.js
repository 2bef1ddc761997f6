// Random cases on a GPU: many of them in one shader, compared with plain numbers within what errors of float32 size do there.
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

/** So many times the errors seen in a few tries; somewhat more than the errors of sines add up to; rounding at the end. */
const safety = 8
const nonlinear = 1.5
const rounding = 1e-5
/** A number that is known no better than this, in proportion to its size above 1, is not compared. */
const mostUncertain = 0.05

/** What is asked of a case here: the value, for each third seed a first derivative, and for each ninth a second one. */
export function gpuResults({ seed, root }) {
  const random = randomOf(seed)
  const used = inputsOf(root)
  const usable = root.shape === 'bool' ? [] : components.filter(({ name }) => used.has(name))
  const first = usable[Math.floor(usable.length * random())]
  const results = [valueResult(root)]
  if (first && seed % 3 === 0) results.push(singleResult(root, first))
  if (seed % 9 === 1) results.push(...secondResults(root, random, 1))
  return results.map((result) => ({ ...result, name: `s${seed}_${result.name}` }))
}

/** The program of some cases for `pipelines.run`; `compile` is ours. */
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

/** A point as `pipelines.run` takes it. */
export const toFloats = (point) => inputs.flatMap(({ name }) => point[name])

/** What a GPU must come to at a point, for each number of each result → { value, tolerance }, or null if not known well. */
export function gpuExpected(test, point) {
  const { root } = test
  const firm = isFirm(root, point)
  return gpuResults(test).map((result) => {
    const { entries } = result
    if (!firm) return Array(sizeOf(root.shape)).fill(null)
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
      return tolerance <= mostUncertain * scale ? { value, tolerance } : null
    })
  })
}

/**
 * Compares what a GPU gave for the cases of a program at each point → { failures, counts }; `expected` has what `gpuExpected`
 * gives, by case and by point.
 */
export function compareGpu(cases, given, expected) {
  const counts = { compared: 0, total: 0 }
  const failures = []
  let start = 0
  for (const [c, test] of cases.entries()) {
    let failure
    for (const [r, result] of gpuResults(test).entries()) {
      const size = sizeOf(result.shape)
      for (const [p, point] of test.points.entries()) {
        const got = Array.from(given[p].slice(start, start + size))
        const wanted = expected[c][p][r]
        counts.total += size
        counts.compared += wanted.filter(Boolean).length
        const isNear = (each, i) => !each || Math.abs(got[i] - each.value) <= each.tolerance
        if (!wanted.every(isNear))
          failure ??= {
            kind: kindOf(result),
            point,
            result,
            got,
            expected: wanted.map((each) => each?.value),
          }
      }
      start += size
    }
    if (failure) failures.push({ test, failure })
  }
  return { failures, counts }
}
