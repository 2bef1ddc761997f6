// Evaluates random expressions of all operations (2,000, or 500 in the default test run) on the CPU in double precision: compares values
// with plain JavaScript, and first and second derivatives with finite differences. A failure prints its seed and a minimized case that
// fails in the same way.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { compile } from '../../dist/warpjet.js'
import { inputs, nodesOf, textOf } from '../random/ast.js'
import { addCounts, callbackOf, checkCase, kinds, noCounts } from '../random/check.js'
import { randomCase } from '../random/generate.js'
import { operationNames } from '../random/operations.js'
import { plainOperations } from '../random/plain.js'
import { describe, shrink } from '../random/shrink.js'

const count = 2000
/** The number of expressions whose values and derivatives are checked. */
const checkedCount = isRun('every random expression') ? count : 500
const cases = Array.from({ length: count }, (_, seed) => randomCase(seed))

/** Compiles a case; returns a function from a point to the results of warpjet. */
function evaluateCase(source) {
  const compiled = compile(callbackOf(source))
  return (point) =>
    compiled.evaluate(
      Object.fromEntries(
        inputs
          .filter(({ name }) => compiled.uniforms.some((uniform) => uniform.name === name))
          .map(({ name, shape }) => [name, shape === 'float' ? point[name][0] : point[name]]),
      ),
    )
}

/** Describes the first `max` failures, minimized. */
async function failuresOf(check, max, among = cases) {
  const failures = []
  for (const test of among) {
    const { failure } = check(test)
    if (failure) failures.push(await shrink(test, failure, (smaller) => check(smaller).failure))
    if (failures.length === max) break
  }
  return failures
}

test('a seed always generates the same expression', () => {
  for (const seed of [0, 7, 1999])
    assert.equal(textOf(randomCase(seed).root), textOf(cases[seed].root))
})

test('every operation is used often', () => {
  const uses = new Map(operationNames.map((name) => [name, 0]))
  for (const { root } of cases)
    for (const { op } of nodesOf(root)) if (uses.has(op)) uses.set(op, uses.get(op) + 1)
  const rare = [...uses].filter(([, times]) => times < 20)
  assert.deepEqual(rare, [])
})

test(`${checkedCount} random expressions have correct values and derivatives`, async (t) => {
  const counts = noCounts()
  const check = (test) => {
    const result = checkCase(test, evaluateCase)
    addCounts(counts, result.counts)
    return result
  }
  const failures = await failuresOf(check, 5, cases.slice(0, checkedCount))
  assert.equal(failures.map(describe).join('\n\n'), '')

  // Up to 5% of the numbers are not compared: those near kinks or jumps, and those sensitive to small errors.
  for (const kind of kinds) {
    const { compared, total } = counts[kind]
    t.diagnostic(`${kind}: ${compared} of ${total} numbers compared`)
    assert(compared >= 0.95 * total, `too few numbers of ${kind} compared: ${compared} of ${total}`)
  }
  const share = checkedCount / count
  assert(counts.value.total > 35000 * share && counts.derivative.total > 150000 * share)
  assert(counts.second.total > 20000 * share)
})

const operationsOf = ({ test }) =>
  [...nodesOf(test.root)].map(({ op }) => op).filter((op) => op !== 'input' && op !== 'number')

test('a wrong value is detected, and minimized to the wrong operation', async () => {
  const wrong = {
    smoothstep: (low, high, x) => Math.min(Math.max((x - low) / (high - low), 0), 1),
    reflect: (v, normal) => v.map((x, i) => x - normal[i]),
    trunc: Math.floor,
  }
  for (const [name, operation] of Object.entries(wrong)) {
    const operations = { ...plainOperations, [name]: operation }
    const [failure] = await failuresOf((test) => checkCase(test, evaluateCase, operations), 1)
    assert.deepEqual(operationsOf(failure), [name], describe(failure))
  }
})

test('a wrong derivative is detected, and minimized to the wrong operation', async () => {
  // Takes the value from one expression, and the derivatives from another.
  const evaluateWrong = (source) => {
    const wrong = source.replace(/^ *const value = (.*)$/m, (line, text) =>
      [line, `  const other = ${text.replaceAll('tanh(', 'atan(')}`].join('\n'),
    )
    return evaluateCase(wrong.replaceAll('(value,', '(other,'))
  }
  const [failure] = await failuresOf((test) => checkCase(test, evaluateWrong), 1)
  assert.deepEqual(operationsOf(failure), ['tanh'], describe(failure))
})

test('an expression that the compiler rejects is detected, and minimized', async () => {
  const rejectInverseOfSinh = (source) => {
    if (/inverse\(.*sinh\(/.test(source)) throw new Error('inverse: not after sinh.')
    return () => ({})
  }
  const check = (test) => {
    const { failure } = checkCase(test, rejectInverseOfSinh)
    return { failure: failure?.kind === 'error' ? failure : undefined }
  }
  const [failure] = await failuresOf(check, 1)
  assert(operationsOf(failure).length <= 5, describe(failure))
})
