// Runs every operation in every language on a real GPU pipeline (WebGL 1 and 2 and WebGPU), and compares the value and its derivatives with
// respect to every number of every operand with the reference of tests/operations, at 320 points. Each row of the reference has its own
// tolerances, explained in tests/operations/reference/tolerances.js.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { brokenConventions, problemsOf } from '../operations/check.js'
import { conventions } from '../operations/conventions.js'
import { programOf } from '../operations/program.js'
import { cases } from '../operations/reference.js'
import { expected, points, swizzleProgram } from '../operations/swizzles.js'
import { openPipelines, targetsInThisRun as targets } from '../support/browser/pipelines.js'

const groups = [...new Set(cases.map(({ group }) => group))]

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines?.close())

/** Returns a function that evaluates a case in a language, at points. */
function runnerOf(operation, target) {
  const program = programOf(operation, target)
  return (points) => pipelines.run(target, program, points)
}

for (const target of targets) {
  describe(`value and every derivative in ${target}:`, () => {
    for (const group of groups)
      test(group, async () => {
        const casesOfGroup = cases.filter((candidate) => candidate.group === group)
        const problems = casesOfGroup.map((operation) =>
          problemsOf(operation, runnerOf(operation, target)),
        )
        assert.deepEqual((await Promise.all(problems)).flat(), [])
      })
  })

  test(`kinks, jumps and boundaries of domains in ${target}`, async () => {
    const problems = []
    for (const convention of conventions) {
      const run = runnerOf(convention.operation, target)
      problems.push(...(await brokenConventions(convention, run)))
    }
    assert.deepEqual(problems, [])
  })

  test(`every swizzle in ${target}`, async () => {
    const [got] = await pipelines.run(target, swizzleProgram(target), points)
    assert.deepEqual([...got], expected)
  })
}
