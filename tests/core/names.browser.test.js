// A function compiles on each pipeline with every name that glsl.fn accepts.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { WarpError, compile } from '../../dist/warpjet.js'
import { candidates } from '../operations/names.js'
import { openPipelines, targets } from '../support/browser/pipelines.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines?.close())

// The pipelines use this name themselves.
const inputs = [{ name: 'given', shape: 2 }]
const outputs = [{ name: 'total', shape: 1 }]

/** The sum of calls of functions with these names and of noise, which calls functions of warpjet. */
const callsOf = (names, target) =>
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
    return !!callsOf([name], target)
  } catch (error) {
    assert.ok(error instanceof WarpError, error.stack)
    return false
  }
}

for (const target of targets)
  test(`every accepted name compiles in ${target}`, async () => {
    const names = candidates.filter((name) => isAccepted(name, target))
    assert.ok(names.length > 100, `${names.length}`)
    const run = async (some) => {
      const program = { ...callsOf(some, target), inputs, outputs }
      return (await pipelines.run(target, program, [[0.5, 0]]))[0][0]
    }
    /** Finds the names that do not compile. */
    async function failures(some) {
      try {
        assert.equal(await run(some), 0.5 * some.length)
        return []
      } catch (error) {
        if (some.length === 1) return [`${some[0]}: ${error.message.split('\n')[0]}`]
        const middle = some.length >> 1
        return [...(await failures(some.slice(0, middle))), ...(await failures(some.slice(middle)))]
      }
    }
    assert.deepEqual(await failures(names), [])
  })
