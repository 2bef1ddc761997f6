// A function compiles on each pipeline with every name that glsl.fn accepts.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { WarpError, compile } from '../../dist/warpjet.js'
import { candidates } from '../operations/names.js'
import { openPipelines, targets } from '../support/browser/pipelines.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines?.close())

// The variables of the shader, whose names are not among the candidates.
const inputs = [{ name: 'given', shape: 2 }]
const outputs = [{ name: 'total', shape: 1 }]

/** Compiles a sum of calls: of functions with these names, and of noise, which calls functions of warpjet. */
const compileCalls = (names, target) =>
  compile(
    (glsl) => {
      const given = glsl.vec2Param('given')
      const called = names.map((name) => {
        const source = {
          glsl: `float ${name}(float x) { return x; }`,
          wgsl: `fn ${name}(x: f32) -> f32 { return x; }`,
        }
        return glsl.fn({ name, arity: 1, source })(given.x())
      })
      return { total: called.reduce((sum, x) => sum.add(x), glsl.noise(given).mult(0)) }
    },
    { target },
  )

const isAccepted = (name, target) => {
  try {
    return !!compileCalls([name], target)
  } catch (error) {
    assert.ok(error instanceof WarpError, error.stack)
    return false
  }
}

for (const target of targets)
  test(`every accepted name compiles in ${target}`, async () => {
    const names = candidates.filter((name) => isAccepted(name, target))
    assert.ok(names.length > 100, `${names.length}`)
    const run = async (subset) => {
      const program = { ...compileCalls(subset, target), inputs, outputs }
      return (await pipelines.run(target, program, [[0.5, 0]]))[0][0]
    }
    /** Returns the names that do not compile, with the message. */
    async function findFailures(subset) {
      try {
        assert.equal(await run(subset), 0.5 * subset.length)
        return []
      } catch (error) {
        if (subset.length === 1) return [`${subset[0]}: ${error.message.split('\n')[0]}`]
        const middle = subset.length >> 1
        return [
          ...(await findFailures(subset.slice(0, middle))),
          ...(await findFailures(subset.slice(middle))),
        ]
      }
    }
    assert.deepEqual(await findFailures(names), [])
  })
