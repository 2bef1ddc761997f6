// The noise of tests/support/noise.js, which is the oracle of other tests, equals the noise that warpjet compiles.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile } from '../../dist/warpjet.js'
import { bases, fractals, kindsOfNoise } from '../operations/noise.js'
import * as plain from '../support/noise.js'

/** Returns points around the origin, some on borders of cells, multiplied by `scale`. */
function pointsOf(n, scale) {
  const random = Array.from({ length: 150 / Math.sqrt(scale) }, (_, i) =>
    Array.from({ length: n }, (_, k) => 20 * scale * Math.sin(12.3 * i + 4.5 * k + 6.7)),
  )
  return [...random, ...[0, 1, -2, 0.5, 7.25].map((x) => Array(n).fill(x * scale))]
}

const optionsOf = (kind) => {
  const seeds = [{}, { seed: 7 }, { seed: -123456 }]
  if (kind === 'curl') return [...seeds, ...bases.map((noise) => ({ noise, seed: 2 }))]
  if (!fractals.includes(kind)) return seeds
  const others = bases.map((noise) => ({ noise, octaves: 3, lacunarity: 2.3, gain: 0.6, seed: 3 }))
  return [...seeds, { octaves: 1 }, ...others]
}

const variable = (glsl, n) => (n === 1 ? glsl.param('p') : glsl[`vec${n}Param`]('p'))

/** Returns the maximum difference between the compiled and the plain noise of a kind. */
function maxDifference(kind, points, options) {
  const n = points[0].length
  const compiled = compile((glsl) => ({ value: glsl[kind](variable(glsl, n), options) }))
  const differences = points.flatMap((p) => {
    const { value } = compiled.evaluate({ p: n === 1 ? p[0] : p })
    const [actual, expected] = [value, plain[kind](p, options)].map((x) => [x].flat())
    assert.equal(actual.length, expected.length)
    return actual.map((x, i) => Math.abs(x - expected[i]))
  })
  return Math.max(...differences)
}

// Maps the scale of points → bound. Far from the origin, doubles are 4e-12 apart, simplex skews its coordinates, and the hash has repeated
// a few times.
const bounds = { 1: 1e-12, 1000: 2e-10 }

describe('the plain noise equals the compiled noise:', () => {
  for (const { kind, dimensions } of kindsOfNoise)
    test(`${kind}, ${dimensions}D`, () => {
      for (const options of optionsOf(kind))
        for (const [scale, bound] of Object.entries(bounds)) {
          const actual = maxDifference(kind, pointsOf(dimensions, scale), options)
          assert.ok(actual <= bound, `${actual} off with ${JSON.stringify(options)}`)
        }
    })
})
