// Checks a compiled expression: its value against plain numbers, its derivatives against finite differences of these. Points near kinks
// and jumps, or with large rounding errors, are not compared, but counted.
import {
  callbackText,
  components,
  derivativeResults,
  evaluate,
  inputsOf,
  secondResult,
  valueResult,
} from './ast.js'
import { choicesAt } from './choices.js'
import { derivative, outermost } from './differences.js'
import { randomOf } from './generate.js'
import { isFirm, roundingSpread } from './noise.js'

/** The tolerance, relative to the size of a value if that is above 1. */
const derivativeTolerance = 1e-6
/** The tolerance for rounding errors of double precision, relative to the size of a value if that is above 1. */
const doubleTolerance = 1e-12
/** Rounding errors of double precision, as a share of the errors of float32 that `noise.js` estimates. */
const doublePerFloat = 1e-8
/** The max uncertainty of a value that is compared, relative to its size if that is above 1. */
const maxUncertain = 1e-2

export const kinds = ['value', 'derivative', 'second']

const scaleOf = (x) => Math.max(1, Math.abs(x))
export const kindOf = ({ entries }) => kinds[entries?.[0]?.by.length ?? 0]

/** Returns all results to check: the value, its first derivatives, and, for every third seed, two second derivatives. */
export function resultsOf({ seed, root }) {
  const random = randomOf(seed)
  const firsts = derivativeResults(root, random)
  return [valueResult(root), ...firsts, ...(seed % 3 ? [] : secondResults(root, random, 2))]
}

/** Returns `count` second derivatives, each with respect to two random components of existing inputs. */
export function secondResults(root, random, count) {
  const usedInputs = inputsOf(root)
  const usable = components.filter(({ name }) => usedInputs.has(name))
  if (root.shape === 'bool' || !usable.length) return []
  const pick = () => usable[Math.floor(usable.length * random())]
  const results = Array.from({ length: count }, () => secondResult(root, pick(), pick()))
  return results.filter(({ name }, i) => results.findIndex((result) => result.name === name) === i)
}

/**
 * Computes the derivatives in a result from finite differences, as [{ value, error }]. The error is infinite if there is a kink at the
 * point or nearby.
 */
export function differentiate(root, { entries }, point, operations) {
  const f = (at) => evaluate(root, at, { operations })
  const [middle, choices] = [f(point), choicesAt(root, point)]
  const cache = new Map()
  return entries.map(({ place, by }) => {
    const key = by.map(({ text }) => text).join()
    if (!cache.has(key)) {
      const isSmooth = outermost(point, by).every((at) => choicesAt(root, at) === choices)
      cache.set(key, isSmooth ? derivative(f, point, by, middle) : undefined)
    }
    return cache.get(key)?.[place] ?? { value: middle[place], error: Infinity }
  })
}

/** Returns the expected numbers of a result at a point, each as { value, tolerance }, or null if it is too uncertain. */
export function expectedAt(root, result, point, operations) {
  if (result.entries)
    return differentiate(root, result, point, operations).map(({ value, error }) =>
      error <= derivativeTolerance * scaleOf(value)
        ? { value, tolerance: 2 * derivativeTolerance * scaleOf(value) }
        : null,
    )
  const middle = evaluate(root, point, { operations })
  const uncertain = roundingSpread(root, middle, (f) => f(point), operations)
  return middle.map((value, i) =>
    uncertain[i] <= maxUncertain * scaleOf(value)
      ? { value, tolerance: doubleTolerance * scaleOf(value) + doublePerFloat * uncertain[i] }
      : null,
  )
}

/** Compiles code to a callback. */
export const callbackOf = (source) => new Function(`return ${source}`)()

const createCounts = () => ({ compared: 0, total: 0 })

/**
 * Compares a case on the CPU; returns { counts, failure }. `counts` has { compared, total } numbers of each kind. `evaluateCase(source)`
 * compiles a callback's code and returns its results at a point, like compile(…).evaluate.
 */
export function checkCase(test, evaluateCase, operations) {
  const { root, points } = test
  const counts = Object.fromEntries(kinds.map((kind) => [kind, createCounts()]))
  const results = resultsOf(test)
  const source = callbackText(root, results)
  const fail = (kind, details) => ({ counts, failure: { kind, source, ...details } })

  let resultsAt
  try {
    resultsAt = points.map(evaluateCase(source))
  } catch (error) {
    return fail('error', { message: error.message })
  }
  for (const [p, point] of points.entries()) {
    const isComparable = isFirm(root, point)
    for (const result of results) {
      const kind = kindOf(result)
      const got = [resultsAt[p][result.name]].flat()
      const allExpected = expectedAt(root, result, point, operations)
      const expected = allExpected.map((each) => (isComparable ? each : null))
      const details = { point, result, got, expected: expected.map((each) => each?.value) }
      if (got.length !== expected.length) return fail('shape', details)
      counts[kind].total += expected.length
      counts[kind].compared += expected.filter(Boolean).length
      if (!expected.every((each, i) => isNear(got[i], each))) return fail(kind, details)
    }
  }
  return { counts }
}

export const isNear = (got, expected) =>
  !expected || Math.abs(got - expected.value) <= expected.tolerance

/** Adds up the counts of `checkCase`. */
export function addCounts(sum, counts) {
  for (const kind of kinds)
    for (const key of ['compared', 'total']) sum[kind][key] += counts[kind][key]
  return sum
}
export const noCounts = () => Object.fromEntries(kinds.map((kind) => [kind, createCounts()]))
