// Checks Quilez' domain warping in two dimensions, at all three levels: compares values, q and r with noise in plain JavaScript, and
// gradients with finite differences, in double precision.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { domainWarp, plainDomainWarp } from '../support/domain-warp.js'

const points = Array.from({ length: 100 }, (_, i) => [3 * Math.sin(1.7 * i), 3 * Math.cos(2.3 * i)])

/** Returns the derivative of `f` with respect to a coordinate, from central differences extrapolated to eliminate the error of h². */
function slope(f, p, axis) {
  const at = (step) => f(p.with(axis, p[axis] + step))
  const difference = (h) => (at(h) - at(-h)) / (2 * h)
  return (4 * difference(1e-5) - difference(2e-5)) / 3
}

describe('a domain warp has the right value and gradient', () => {
  for (const level of [0, 1, 2])
    test(`at level ${level}`, () => {
      const compiled = compile((glsl) => {
        const p = glsl.vec2Param('p')
        const { value, q, r } = domainWarp(glsl, p, level)
        return { value, slope: glsl.gradient(value, p), q, r }
      })
      for (const p of points) {
        const actual = compiled.evaluate({ p })
        const expected = plainDomainWarp(p, level)
        for (const name of ['value', 'q', 'r'])
          [expected[name]].flat().forEach((x, i) => {
            const difference = Math.abs([actual[name]].flat()[i] - x)
            assert.ok(difference < 1e-11, `${name} is ${difference} off at ${p}`)
          })
        const slopes = [0, 1].map((axis) =>
          slope((at) => plainDomainWarp(at, level).value, p, axis),
        )
        const error = Math.hypot(...slopes.map((x, i) => x - actual.slope[i]))
        const bound = 1e-6 * Math.max(1, Math.hypot(...slopes))
        assert.ok(error < bound, `the gradient is ${error} off ${slopes} at ${p}`)
      }
    })
})
