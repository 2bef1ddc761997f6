// Evaluates every kind of noise in every language on a real GPU pipeline, and compares values and first and second derivatives with the CPU
// in double precision, which tests/core/noise.test.js checks. If values agree to 1e-4, a baked mesh looks like the one on the screen.
import assert from 'node:assert/strict'
import { after, before, describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import {
  isFractal,
  kindsOfNoise,
  noisePoints,
  propertiesOf,
  settingsOf,
} from '../operations/noise.js'
import { components } from '../operations/program.js'
import { openPipelines, targetsInThisRun as targets } from '../support/browser/pipelines.js'

const makers = ['param', 'vec2Param', 'vec3Param', 'vec4Param']

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines?.close())

/** Makes a program for the values, the derivatives of the first value, and the derivatives of the first of these. */
function programOf(kind, dimensions, options, target) {
  const { size } = propertiesOf[kind]
  const program = compile(
    (glsl) => {
      const p = glsl[makers[dimensions - 1]]('p')
      const noise = glsl[kind](p, options)
      const inputs = components(p, dimensions)
      const value = size === 1 ? noise : noise.x()
      const slopes = inputs.map((input) => glsl.derivative(value, input))
      const bends = inputs.map((input) => glsl.derivative(slopes[0], input))
      const named = (list, name) => list.map((expression, i) => [`${name}${i}`, expression])
      return {
        noise,
        ...Object.fromEntries([...named(slopes, 'slope'), ...named(bends, 'bend')]),
      }
    },
    { target },
  )
  const numbers = ['slope', 'bend'].flatMap((name) =>
    Array.from({ length: dimensions }, (_, i) => ({ name: `${name}${i}`, shape: 1 })),
  )
  return {
    ...program,
    inputs: [{ name: 'p', shape: dimensions }],
    outputs: [{ name: 'noise', shape: size }, ...numbers],
  }
}

for (const target of targets) {
  describe(`noise in ${target}:`, () => {
    for (const { kind, dimensions } of kindsOfNoise)
      test(`${kind} of ${dimensions} dimensions`, async () => {
        const options = settingsOf(kind)
        const program = programOf(kind, dimensions, options, target)
        // Fractals are compared near the origin: further away, float32 rounds the coordinates, which octaves multiply.
        const points = noisePoints(dimensions, 60, isFractal(kind) ? 12 : undefined)
        const got = await pipelines.run(target, program, points)
        const { size } = propertiesOf[kind]
        const problems = []
        points.forEach((point, k) => {
          const expected = Object.values(program.evaluate({ p: point })).flat()
          expected.forEach((value, i) => {
            const error = Math.abs(got[k][i] - value)
            // First and second derivatives have the same relative accuracy.
            const bound = i < size ? 1e-4 : 1e-4 * Math.max(1, ...expected.map(Math.abs))
            if (!(error <= bound))
              problems.push(`${point}: number ${i} is ${got[k][i]}, not ${value}`)
          })
        })
        assert.deepEqual(problems.slice(0, 5), [])
      })
  })
}
