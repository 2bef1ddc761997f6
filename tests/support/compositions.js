// Compares compositions of deformers with the same compositions of oracles: functions of numbers, which are evaluated one after another in
// double precision.
import assert from 'node:assert/strict'
import { bend, twist, wave } from '../../dist/deformers.js'
import { compile } from '../../dist/warpjet.js'
import { deformers as oracles } from '../warps/deformers.js'
import { seededRandom } from '../warps/random.js'
import { normalize, add as plus } from './browser/matrix.js'
import { angleBetween, jacobian, warpVertex } from './browser/oracle.js'

const random = seededRandom(66)
const randomPoint = (size) => [0, 1, 2].map(() => size * (2 * random() - 1))
export const vertices = Array.from({ length: 40 }, () => ({
  position: randomPoint(120),
  normal: normalize(randomPoint(1)),
  millis: 1234,
}))
/** The step of finite differences. */
export const step = 0.02

/**
 * Returns a function that evaluates a warp in double precision: it maps a vertex and uniforms to the offset, the columns of the offset's
 * Jacobian, and the warped normal.
 */
export function inDouble(warp) {
  return compile((glsl) => {
    const [position, normal] = [glsl.vec3Param('position'), glsl.vec3Param('normal')]
    const millis = glsl.param('millis')
    const offset = warp({ glsl, position, normal, millis })
    return {
      offset,
      derivatives: glsl.jacobian(offset, position),
      warpedNormal: offset.adjustNormal(normal, position),
      // Makes sure that all inputs are read, so that `evaluate` accepts them.
      unused: normal.mult(millis),
    }
  }).evaluate
}

export function assertClose(actual, expected, tolerance) {
  actual.forEach((value, i) => {
    const off = Math.abs(value - expected[i])
    assert.ok(off <= tolerance, `${actual} is not ${expected}: ${off} off`)
  })
}

/** Asserts that offsets, Jacobians and normals agree. `oracle` is a function (position, { normal, millis, ... }) → offset. */
export function agree(warp, oracle, uniforms = {}) {
  const evaluate = inDouble(warp)
  for (const vertex of vertices) {
    const inputs = { ...vertex, ...uniforms }
    const { offset, derivatives, warpedNormal } = evaluate(inputs)
    assertClose(offset, oracle(vertex.position, inputs), 1e-9)
    const columns = jacobian((p) => oracle(p, inputs), vertex.position, step)
    if (!columns) continue
    assertClose(derivatives, columns.flat(), 1e-7)
    const expected = warpVertex(oracle, vertex, inputs, step)
    if (!expected.normal?.some(Boolean)) continue
    const angle = angleBetween(warpedNormal, expected.normal)
    assert.ok(angle < 1e-5 * expected.sensitivity, `${angle}° at ${vertex.position}`)
  }
}

/** Pairs: a deformer and its oracle. `bent` and `waved` are, too. */
export const twisted = [twist({ angle: 1.3 }), oracles.twist({ angle: 1.3 })]
export const bent = [
  bend({ axis: 'x', angle: 1, from: -150, to: 150 }),
  oracles.bend({ axis: 'x', angle: 1, from: -150, to: 150 }),
]
export const waved = [wave({ amount: 5 }), oracles.wave({ amount: 5 })]

export const times = (v, factor) => v.map((x) => x * factor)
/** Returns the composition of two offsets: first `a`, then `b`. */
export const after = (a, b) => (p, inputs) => {
  const first = a(p, inputs)
  return plus(first, b(plus(p, first), inputs))
}
/** Returns the normal of the surface that `offset` moves, at the moved point p, from finite differences only. */
export const normalAfter = (offset, p, inputs) =>
  warpVertex(offset, { position: p, normal: inputs.normal }, inputs, step).normal
