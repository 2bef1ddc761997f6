// Tests the formulas of noise in the docs. Evaluates their text in double precision, with the corners, feature points and octaves of the
// plain noise of tests/support. The values must equal those of the plain noise and of warpjet, the derivatives must equal the central
// differences of the plain noise and the derivatives of warpjet.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { noiseFormulas } from '../../.scripts/reference/noise-formulas.mjs'
import { compile } from '../../dist/warpjet.js'
import { fractals } from '../operations/noise.js'
import { add, dot, subtract, times } from '../support/linear.js'
import * as plain from '../support/noise.js'
import { evaluateFormula } from '../support/notation.js'

const { bases, direction, hash } = plain
const seed = hash(0, 0)
const fade = (t) => t ** 3 * (6 * t ** 2 - 15 * t + 10)
const step = 1e-5
/** Returns the directional derivative of `f` along dp, from a central difference. */
const slope = (f, p, dp) =>
  times(0.5 / step, subtract(f(add(p, times(step, dp))), f(add(p, times(-step, dp)))))

/** Returns the variables of the corners of the cell around a point, with the names of the docs. */
function corners(p, dp) {
  const cell = p.map(Math.floor)
  const all = [[0, 0], [0, 1], [1, 0], [1, 1]].map((corner) => add(cell, corner)) // prettier-ignore
  const hashes = all.map((corner) => corner.reduce(hash, seed))
  const weightAt = (corner) => (q) =>
    q.reduce((product, x, i) => product * fade(1 - Math.abs(x - corner[i])), 1)
  return {
    count: 4,
    s: 2 / Math.sqrt(2),
    o: all.map((corner) => subtract(p, corner)),
    g: hashes.map((h) => direction(h, 2)),
    h: hashes.map((h) => (2 * h) / 4090 - 1),
    w: all.map((corner) => weightAt(corner)(p)),
    dw: all.map((corner) => slope(weightAt(corner), p, dp)),
  }
}

/** Returns the variables of the corners of the triangle around a point, found by the skew of Gustavson 2005. */
function triangle(p) {
  const [skew, unskew] = [(Math.sqrt(3) - 1) / 2, (3 - Math.sqrt(3)) / 6]
  const cell = p.map((x) => Math.floor(x + skew * (p[0] + p[1])))
  const from = (corner) => corner.map((c, i) => p[i] - c + unskew * (corner[0] + corner[1]))
  const [x, y] = from(cell)
  const all = [[0, 0], x >= y ? [1, 0] : [0, 1], [1, 1]].map((corner) => add(cell, corner)) // prettier-ignore
  const o = all.map(from)
  const g = all.map((corner) => direction(corner.reduce(hash, seed), 2))
  return {
    count: 3,
    s: 99.2043,
    o,
    g,
    r: o.map((fromCorner) => Math.max(0.5 - dot(fromCorner, fromCorner), 0)),
  }
}

/** Locates the nearest feature point, from the distances to it at three close points. */
function nearest(p) {
  const places = [0, 1, 2].map((i) =>
    p.map(
      (x, k) =>
        x +
        1e-3 *
          [
            [0, 0],
            [1, 0],
            [0, 1],
          ][i][k],
    ),
  )
  const [a, b, c] = places.map((q) => plain.worley(q)[0] ** 2)
  return { c: [(a - b + 1e-6) / 2e-3 + p[0], (a - c + 1e-6) / 2e-3 + p[1]] }
}

/** Returns the variables of the octaves at a point, with their gains `g`, values `n` and derivatives `dn`. */
function octaves(p, dp) {
  const shifts = [0.6180339887498949, 0.7548776662466927]
  const all = [0, 1, 2, 3, 4].map((k) => {
    const q = p.map((x, i) => x * 2 ** k + k * shifts[i])
    return bases.noise(q, k ? hash(seed, k) : seed)
  })
  return {
    count: 5,
    g: all.map((_, k) => 0.5 ** k),
    n: all.map(({ value }) => value),
    dn: all.map(({ gradient }, k) => 2 ** k * dot(gradient, dp)),
  }
}

/** Returns the gradients of the three noises and the derivatives of these, which the docs write as quotients, `∂N₃/∂y`. */
function threeNoises(p, dp) {
  const gradients = [1, 2, 3].map((i) => (q) => bases.noise(q, hash(seed, i)).gradient)
  const gradientComponents = (i) => gradients.map((gradient) => gradient(p)[i])
  const derivatives = (i) => gradients.map((gradient) => slope(gradient, p, dp)[i])
  return Object.fromEntries(
    ['x', 'y', 'z'].flatMap((axis, i) => [
      [`N${axis}`, gradientComponents(i)],
      [`dN${axis}`, derivatives(i)],
    ]),
  )
}
const withoutQuotients = (text) => text.replaceAll(/∂(d?N)([₁₂₃])\/∂([xyz])/g, '$1$3$2')

const variablesOf = {
  noise: corners,
  valueNoise: corners,
  simplex: triangle,
  worley: nearest,
  curl: threeNoises,
  ...Object.fromEntries(fractals.map((name) => [name, octaves])),
}

/** Returns the value that the docs show: of the two values of worley, the first. */
const first = (name, result) => (name === 'worley' ? result[0] : result)

for (const [name, { value, derivative }] of Object.entries(noiseFormulas))
  test(`${name} is ${value}, and its derivative ${derivative}`, () => {
    const n = name === 'curl' ? 3 : 2
    const program = compile((glsl) => {
      const [t, p, dp] = [glsl.param('time'), glsl[`vec${n}Param`]('p'), glsl[`vec${n}Param`]('dp')]
      const result = glsl[name](p.add(dp.mult(t)))
      const shown = name === 'worley' ? result.x() : result
      return { value: shown, derivative: glsl.derivative(shown, t) }
    })
    for (let i = 0; i < 12; i++) {
      const p = [7.3, 2.9, -4.1].slice(0, n).map((x) => x * Math.sin(3.3 * i + x))
      const dp = [0.8, -0.5, 0.3].slice(0, n)
      const variables = { p, dp, ...variablesOf[name](p, dp) }
      const actual = program.evaluate({ time: 0, p, dp })
      const expected = [value, derivative].map((text) =>
        evaluateFormula(withoutQuotients(text), variables),
      )
      const field = (q) => first(name, plain[name](q))
      const numbers = [field(p), slope(field, p, dp), actual.value, actual.derivative]
      for (const [k, result] of numbers.entries())
        for (const [j, x] of [result].flat().entries()) {
          const other = [expected[k % 2]].flat()[j]
          assert.ok(Math.abs(x - other) < 2e-6 * Math.max(1, Math.abs(other)), `at ${p}: ${x}, not ${other} (${k})`) // prettier-ignore
        }
    }
  })
