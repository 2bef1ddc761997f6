// The bounds of a warp contain its warped positions.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { moments } from '../support/browser/compare.js'
import { warps } from '../warps/index.js'

describe('bounds', () => {
  const box = (size) => ({ min: [-size, -size, -size], max: [size, size, size] })

  const cells = 10

  /** Returns the bounds of the warped positions of a grid of points in a box. */
  function sampleBox(offset, size, inputs) {
    const truth = { min: Array(3).fill(Infinity), max: Array(3).fill(-Infinity) }
    for (let i = 0; i <= cells; i++)
      for (let j = 0; j <= cells; j++)
        for (let k = 0; k <= cells; k++) {
          const p = [i, j, k].map((n) => size * ((2 * n) / cells - 1))
          const normal = p.map((x) => Math.sign(x) / Math.sqrt(3))
          const uv = [i / cells, j / cells]
          const vertexInputs = { ...inputs, position: p, normal, uv, color: [0, 1, 0.5, 1] }
          offset(p, vertexInputs).forEach((x, axis) => {
            truth.min[axis] = Math.min(truth.min[axis], p[axis] + x)
            truth.max[axis] = Math.max(truth.max[axis], p[axis] + x)
          })
        }
    return truth
  }

  const contains = ({ min, max }, truth) =>
    [0, 1, 2].every((axis) => min[axis] <= truth.min[axis] && max[axis] >= truth.max[axis])

  for (const { name, compile, offset, size, reach, params, isGolden } of warps) {
    const warp = compile('glsl300')
    if (!warp.bounds) continue
    test(`contain the warped box, and are at most twice as large in the gallery: ${name}`, () => {
      for (const moment of moments) {
        const all = { ...moment, ...params }
        const bounds = warp.bounds(box(size), { uniforms: all })
        const truth = sampleBox(offset, size, all)
        assert.ok(contains(bounds, truth), `${JSON.stringify([bounds, truth])}`)
        for (let axis = 0; isGolden && axis < 3; axis++) {
          const extent = Math.max(truth.max[axis] - truth.min[axis], reach / 1000)
          const ratio = (bounds.max[axis] - bounds.min[axis]) / extent
          assert.ok(ratio <= 2, `${ratio} times as large as needed`)
        }
      }
    })
  }

  // A grid of 25 × 25 × 25 has the same result.
  test('that are 5% too small would fail the previous test for nearly every warp', () => {
    const moment = moments[1]
    const detected = warps.filter(({ compile, offset, size, params }) => {
      const inputs = { ...moment, ...params }
      const bounds = compile('glsl300').bounds?.(box(size), { uniforms: inputs })
      if (!bounds) return false
      const { min, max } = bounds
      const inwards = (ends, others) => ends.map((x, i) => x + 0.05 * (others[i] - x))
      const tooSmall = { min: inwards(min, max), max: inwards(max, min) }
      return !contains(tooSmall, sampleBox(offset, size, inputs))
    })
    assert.ok(detected.length >= 65, `only ${detected.length} of ${warps.length}`)
  })

  test('contain both sides of the cut of atan(y, x), also for a plane', () => {
    const angle = compileWarp(({ glsl, position }) =>
      glsl.vec3(0, 0, position.y().atan(position.x())),
    )
    const { min, max } = angle.bounds({ min: [-1, 0, 0], max: [1, 0, 0] })
    assert.ok(min[2] <= -Math.PI && max[2] >= Math.PI, `${min[2]} to ${max[2]}`)
    assert.ok(max[2] >= angle.evaluateAt([-1, 0, 0]).position[2])
  })

  test('assume uvs from 0 to 1 by default', () => {
    const warp = compileWarp(({ glsl, uv, color, normal }) =>
      glsl.vec3(uv.x(), color.x(), normal.x()),
    )
    const point = { min: [0, 0, 0], max: [0, 0, 0] }
    const assertNear = (actual, expected) =>
      actual.forEach((x, i) => assert.ok(Math.abs(x - expected[i]) < 1e-3, `${actual}`))
    assertNear(warp.bounds(point).min, [0, 0, -1])
    assertNear(warp.bounds(point).max, [1, 1, 1])
    const wider = warp.bounds({ ...point, uvs: { min: [-2, 0], max: [5, 0] } })
    assertNear(wider.min, [-2, 0, -1])
    assertNear(wider.max, [5, 1, 1])
  })
})

describe('bounds of a warp that is NaN somewhere', () => {
  const box = { min: [-1, -1, -1], max: [1, 1, 1] }
  const boundsOf = (offset) => compileWarp(offset).bounds(box)
  /** Checks that bounds contain these numbers, and are not much larger. */
  function assertAround([min, max], [low, high]) {
    assert.ok(min <= low && low - min < 0.05 && max >= high && max - high < 0.05, `${[min, max]}`)
  }

  test('contain the other values', () => {
    const root = boundsOf(({ glsl, position: { x, y } }) =>
      glsl.vec3(y.sqrt(), 0, x.asin().mult(2)),
    )
    assertAround([root.min[0], root.max[0]], [-1, 2])
    assertAround([root.min[1], root.max[1]], [-1, 1])
    const arcSineBounds = boundsOf(({ glsl, position: { x } }) => glsl.vec3(0, x.mult(3).asin(), 0))
    assertAround([arcSineBounds.min[1], arcSineBounds.max[1]], [-1 - Math.PI / 2, 1 + Math.PI / 2])
  })

  test('are infinite if the values are, and empty if there are none', () => {
    const pole = boundsOf(({ glsl, position: { x } }) => glsl.vec3(0, x.log(), 0))
    assert.equal(pole.min[1], -Infinity)
    assert.ok(pole.max[1] >= 1 && pole.max[1] < 1.05)
    const { min, max } = boundsOf(({ glsl, position: { x } }) => glsl.vec3(0, x.sub(2).sqrt(), 0))
    assert.deepEqual([min[1], max[1]], [Infinity, -Infinity])
    assertAround([min[0], max[0]], [-1, 1])
  })
})

test('bounds of tan are finite between any two poles', () => {
  const warp = compileWarp(({ glsl, position }) => glsl.vec3(0, position.x().tan(), 0))
  const { min, max } = warp.bounds({ min: [6.2, 0, 0], max: [6.4, 0, 0] })
  assert.ok(min[1] > Math.tan(6.2) - 0.01 && max[1] < Math.tan(6.4) + 0.01, `${min[1]} ${max[1]}`)
})
