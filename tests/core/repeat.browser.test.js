// Runs random nested loops on real GPU pipelines, and compares values and slopes with plain loops in double precision.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { foldCallback, foldNumber, randomFoldCase, slopes } from '../random/folds.js'
import { openPipelines, targetsInThisRun as targets } from '../support/browser/pipelines.js'

const count = 120
/** The number of loops that share a shader. */
const blockSize = 40

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines.close())

/** The tolerance of values: a sine on a GPU is off by 2e-4, and each step passes its error to the next. */
const sineTolerance = 2e-3
/** Each input is shifted by this much to measure how errors grow: the tolerance includes the change of a result. */
const step = 2e-3
const maxUncertainty = 0.1

/** Returns [{ value, tolerance }] for the value and the slopes at a point, with `null` where errors grow or a kink is near. */
function expectedOf(fold, point) {
  const resultsAt = (p) => [{ value: foldNumber(fold, p), isFirm: true }, ...slopes(fold, p)]
  const near = point.flatMap((_, i) =>
    [-step, step].map((shift) => resultsAt(point.map((x, k) => (k === i ? x + shift : x)))),
  )
  return resultsAt(point).map(({ value, isFirm }, i) => {
    const scale = Math.max(1, Math.abs(value))
    const spread = Math.max(...near.map((results) => Math.abs(results[i].value - value)))
    const tolerance = sineTolerance * scale + 2 * spread
    const isComparable = isFirm && near.every((results) => results[i].isFirm)
    return isComparable && tolerance <= maxUncertainty * scale ? { value, tolerance } : null
  })
}

/** Returns the value and three slopes of each loop at each point. */
async function run(target, folds, points, change = (code) => code) {
  const compiled = folds.map((fold) => {
    const second = `second${fold.seed}`
    return compile(
      (glsl) => {
        const { [second]: _, ...results } = foldCallback(fold)(glsl)
        return results
      },
      { target },
    )
  })
  const program = {
    code: change(compiled.map(({ code }) => code).join('\n')),
    declarations: [...new Set(compiled.map(({ declarations }) => declarations))].join('\n'),
    inputs: folds[0].inputs.map((name) => ({ name, shape: 1 })),
    outputs: folds.flatMap(({ seed }) => [
      { name: `value${seed}`, shape: 1 },
      { name: `slope${seed}`, shape: 3 },
    ]),
  }
  return pipelines.run(target, program, points)
}

/** Returns descriptions of the wrong results, and how many numbers were compared, of how many. */
function judge(folds, points, results) {
  const judgement = { wrong: [], compared: 0, total: 0 }
  for (const [p, point] of points.entries())
    for (const [f, fold] of folds.entries()) {
      const actual = Array.from(results[p].slice(4 * f, 4 * f + 4))
      const expected = expectedOf(fold, point)
      judgement.total += 4
      judgement.compared += expected.filter(Boolean).length
      const isWrong = (number, i) =>
        number && !(Math.abs(actual[i] - number.value) <= number.tolerance)
      if (expected.some(isWrong))
        judgement.wrong.push(
          `seed ${fold.seed} at ${point}: ${actual}, not ${expected.map((number) => number?.value)}`,
        )
    }
  return judgement
}

const blocks = Array.from({ length: count / blockSize }, (_, block) =>
  Array.from({ length: blockSize }, (_, i) => randomFoldCase(block * blockSize + i)),
)
const pointsOf = (folds) => folds.slice(0, 3).map(({ point }) => point)

for (const target of targets)
  test(`${target}: ${count} random loops equal those of JavaScript`, async (t) => {
    const all = { wrong: [], compared: 0, total: 0 }
    for (const folds of blocks) {
      const points = pointsOf(folds)
      const { wrong, compared, total } = judge(folds, points, await run(target, folds, points))
      all.wrong.push(...wrong)
      all.compared += compared
      all.total += total
    }
    assert.deepEqual(all.wrong, [])
    t.diagnostic(`${all.compared} of ${all.total} numbers compared`)
    assert(all.compared >= 0.8 * all.total, `only ${all.compared} of ${all.total} compared`)
  })

test('a loop with one step less is detected', async () => {
  const shorter = (code) => code.replace(/ < (\d+);/g, (_, steps) => ` < ${steps - 1};`)
  const points = pointsOf(blocks[0])
  const { wrong } = judge(blocks[0], points, await run('glsl300', blocks[0], points, shorter))
  assert(wrong.length > 0)
})
