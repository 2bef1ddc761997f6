// Runs the random expressions of tests/compile/random.test.js on real GPU pipelines in every language, and compares values and some
// derivatives within the error that float32 rounding can cause. Forty expressions share a shader; a failure is traced to one of them, and
// minimized.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { setImmediate } from 'node:timers/promises'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { compile } from '../../dist/warpjet.js'
import { callbackText } from '../random/ast.js'
import { blockSize, randomCase } from '../random/generate.js'
import { compareGpu, gpuExpected, gpuResults, programOf, toFloats } from '../random/gpu.js'
import { describe, shrink } from '../random/shrink.js'
import { openPipelines, targetsInThisRun as targets } from '../support/browser/pipelines.js'

const count = isRun('every random expression') ? 2000 : 400
const maxFailures = 3

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines.close())

const expectedOf = (test) => test.points.map((point) => gpuExpected(test, point))

/** Evaluates cases in one shader; returns { results } or { error }. The last test passes a wrong `compiler` instead of warpjet's. */
async function runCases(target, cases, compiler = compile) {
  try {
    const program = programOf(cases, target, compiler)
    return { results: await pipelines.run(target, program, cases[0].points.map(toFloats)) }
  } catch (error) {
    return { error }
  }
}

/** Judges results of `runCases`; returns { failures, counts }. Shaders that do not compile are split into smaller ones. */
async function judge(target, cases, expected, { results, error }) {
  if (results) return compareGpu(cases, results, expected)
  if (cases.length === 1) {
    const failure = { kind: 'error', message: error.message }
    return { failures: [{ test: cases[0], failure }], counts: none() }
  }
  const half = cases.length >> 1
  const judgements = []
  for (const range of [
    [0, half],
    [half, cases.length],
  ]) {
    const part = cases.slice(...range)
    judgements.push(
      await judge(target, part, expected.slice(...range), await runCases(target, part)),
    )
  }
  // Each case passes alone, but not together with others: names collide, or the shader is too large.
  if (!judgements.some(({ failures }) => failures.length)) throw error
  return {
    failures: judgements.flatMap(({ failures }) => failures),
    counts: judgements.map(({ counts }) => counts).reduce(addCounts, none()),
  }
}

const none = () => ({ compared: 0, total: 0 })
const addCounts = (a, b) => ({ compared: a.compared + b.compared, total: a.total + b.total })

async function failureOf(target, test) {
  const outcome = await runCases(target, [test])
  const { failures } = await judge(target, [test], [expectedOf(test)], outcome)
  return failures[0]?.failure
}

/** Describes the failures of one random case. It is minimized for the first language in which it failed. */
async function report([{ target, test, failure }, ...others]) {
  const small = await shrink(test, failure, (smaller) => failureOf(target, smaller))
  const source = callbackText(small.test.root, gpuResults(small.test))
  const names = [target, ...others.map((other) => other.target)].join(', ')
  return `${names}, ${describe({ ...small, failure: { ...small.failure, source } })}`
}

test(`${count} random expressions compile and agree in every language`, async (t) => {
  const sums = Object.fromEntries(targets.map((target) => [target, none()]))
  const failed = new Map()
  for (let first = 0; first < count && failed.size < maxFailures; first += blockSize) {
    const cases = Array.from({ length: blockSize }, (_, i) => randomCase(first + i))
    const running = targets.map((target) => runCases(target, cases))
    const expected = []
    for (const test of cases) {
      expected.push(expectedOf(test))
      // Lets the event loop handle messages of the browser, which evaluates the shaders meanwhile.
      await setImmediate()
    }
    for (const [i, target] of targets.entries()) {
      const { failures, counts } = await judge(target, cases, expected, await running[i])
      sums[target] = addCounts(sums[target], counts)
      for (const caseFailure of failures) {
        const { seed } = caseFailure.test
        failed.set(seed, [...(failed.get(seed) ?? []), { target, ...caseFailure }])
      }
    }
  }
  const texts = []
  for (const failures of [...failed.values()].slice(0, maxFailures))
    texts.push(await report(failures))
  assert.equal(texts.join('\n\n'), '')

  for (const target of targets) {
    const { compared, total } = sums[target]
    t.diagnostic(`${target}: ${compared} of ${total} numbers compared`)
    assert(total > 20 * count && compared >= 0.95 * total, `only ${compared} of ${total} compared`)
  }
})

test('wrong code is detected', async () => {
  const wrong = (callback, options) => {
    const compiled = compile(callback, options)
    return { ...compiled, code: compiled.code.replaceAll('max(', 'min(') }
  }
  const cases = Array.from({ length: blockSize }, (_, seed) => randomCase(seed))
  const outcome = await runCases('glsl300', cases, wrong)
  const { failures } = await judge('glsl300', cases, cases.map(expectedOf), outcome)
  assert(failures.length > 0)
})
