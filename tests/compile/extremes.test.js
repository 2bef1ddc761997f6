// Normals, bounds and comparisons equal those of exact arithmetic even if intermediate results overflow or underflow in float32.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { bases } from '../operations/noise.js'
import { extremes } from '../warps/extremes.js'

describe('a finite offset has a finite and correct normal:', () => {
  for (const { name, offset, points } of extremes)
    test(name, () => {
      const warp = compileWarp(offset)
      for (const { position, normal, expected } of points) {
        const actual = warp.evaluateAt(position, { normal })
        assert.ok(
          actual.position.every(Number.isFinite),
          `${name} is ${actual.position} at ${position}`,
        )
        actual.normal.forEach((x, i) =>
          assert.ok(
            Math.abs(x - expected[i]) < 1e-6,
            `${actual.normal}, not ${expected}, at ${position}`,
          ),
        )
      }
    })

  test('an infinite slope has a zero normal, not NaN', () => {
    const warp = compileWarp(({ glsl, position }) => glsl.vec3(0, glsl.val(1).div(position.x()), 0))
    assert.deepEqual(warp.evaluateAt([1e-25, 0, 0], { normal: [0, 1, 0] }).normal, [0, 0, 0])
  })
})

test('foldover finds the correct side even if intermediate derivatives overflow', () => {
  const mirrored = compileWarp(({ glsl, position }) => {
    const x = position.x()
    return glsl.vec3(glsl.val(1).div(x.neg().exp().add(1)).sub(x.mult(2)), 0, 0)
  })
  const { mask } = mirrored.foldover({
    positions: [-100, 0, 0, 0, 0, 0],
    normals: [0, 1, 0, 0, 1, 0],
  })
  assert.deepEqual([...mask], [1, 1])
  const huge = compileWarp(({ position }) => position.mult(1e10))
  assert.equal(huge.foldover({ positions: [1, 2, 3], normals: [0, 1, 0] }).count, 0)
})

describe('bounds contain the float32 result of', () => {
  const boundsOf = (size, height) =>
    compileWarp(({ glsl, position }) => glsl.vec3(0, 0, height(position.x(), glsl))).bounds({
      min: [-size, 0, 0],
      max: [size, 0, 0],
    })
  test('an overflow', () => assert.equal(boundsOf(100, (x) => x.cosh()).max[2], Infinity))
  test('an underflow', () => {
    // exp(-200) is 0 in float32, and so is 1 / cosh(200).
    const { max } = boundsOf(200, (x) => x.exp().gt(0).ifElse(0, 100).sub(x))
    assert.ok(max[2] >= 300, `${max[2]}`)
    const flat = boundsOf(200, (x, glsl) => glsl.val(1).div(x.cosh()).sign().mult(50).sub(x))
    assert.ok(flat.min[2] <= -200, `${flat.min[2]}`)
  })
})

for (const base of bases)
  test(`bounds of a curl and of a gradient of ${base} are within 30`, () => {
    const box = { min: [-2, -2, -2], max: [2, 2, 2] }
    const curl = compileWarp(({ glsl, position }) => glsl.curl(position, { noise: base }))
    const slope = compileWarp(({ glsl, position }) =>
      glsl.vec3(0, 0, glsl.derivative(glsl[base](position), position.x())),
    )
    for (const { min, max } of [curl.bounds(box), slope.bounds(box)])
      assert.ok(max[2] < 30 && min[2] > -30, `${min[2]} to ${max[2]}`)
  })

test('bounds of gradients of octaves and cells contain them, and are not much larger', () => {
  const box = { min: [-2, -2, -2], max: [2, 2, 2] }
  const fields = {
    fbm: (glsl, p) => glsl.fbm(p),
    ridged: (glsl, p) => glsl.ridged(p),
    turbulence: (glsl, p) => glsl.turbulence(p),
    worley: (glsl, p) => glsl.worley(p).x(),
  }
  for (const [name, field] of Object.entries(fields)) {
    const slope = compileWarp(({ glsl, position }) =>
      glsl.vec3(0, 0, glsl.derivative(field(glsl, position), position.x()).sub(position.z())),
    )
    // Points of the box, in steps that are incommensurable with the lattice. The warped z is the derivative.
    const positions = Array.from({ length: 3e4 }, (_, i) => [
      ((i * 0.7548776662) % 1) * 4 - 2,
      ((i * 0.569840291) % 1) * 4 - 2,
      ((i * 0.381966) % 1) * 4 - 2,
    ]).flat()
    const { positions: moved } = slope.evaluate({ positions, normals: positions })
    const actual = moved.filter((_, i) => i % 3 === 2)
    const [low, high] = [Math.min(...actual), Math.max(...actual)]
    const { min, max } = slope.bounds(box)
    assert.ok(
      min[2] <= low && max[2] >= high,
      `${name}: ${min[2]} to ${max[2]}, not ${low} to ${high}`,
    )
    // z cancels out, but not in interval arithmetic: 4 on either side.
    assert.ok(
      max[2] < 60 && min[2] > -60,
      `${name}: ${min[2]} to ${max[2]}, found ${low} to ${high}`,
    )
  }
})

test('constants are compared in float32, like in a shader', () => {
  const { code, evaluate } = compile((glsl) => ({
    isSum: glsl.val(0.1).add(0.2).eq(0.3).ifElse(5, 7),
    isLess: glsl.val(0.3).lt(glsl.val(0.1).add(0.2)).ifElse(5, 7),
    sum: glsl.val(0.1).add(0.2),
  }))
  assert.match(code, /isSum = 5\.0/)
  assert.match(code, /isLess = 7\.0/)
  assert.deepEqual(evaluate(), { isSum: 5, isLess: 7, sum: 0.1 + 0.2 })
})
