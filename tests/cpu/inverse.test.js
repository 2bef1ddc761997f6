// Tests inverseAt, which finds a position that a warp moves to a given point, against inverses derived by hand.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'

const twist = compileWarp(({ glsl, position }) =>
  glsl.rotateY(position.y().mult(2)).mult(position).sub(position),
)

/** Makes a warp that moves x by an offset that depends on x alone. */
const warpOfX = (offset) =>
  compileWarp(({ glsl, position }) => glsl.vec3(offset(position.x(), glsl), 0, 0))

const assertClose = (actual, expected, bound) =>
  assert.ok(
    Math.hypot(...actual.map((x, i) => x - expected[i])) <= bound,
    `${actual} is not ${expected}`,
  )

test('a twist is undone by the opposite twist, from anywhere', () => {
  for (let i = 0; i < 500; i++) {
    const from = [Math.sin(i), Math.cos(2.1 * i), Math.sin(3.7 * i + 1)].map((x) => 3 * x)
    const [x, y, z] = from
    const [c, s] = [Math.cos(2 * y), Math.sin(2 * y)]
    // evaluateAt shows in which direction the warp rotates about y.
    const [moved] = twist.evaluateAt(from).position
    const to =
      Math.abs(moved - (c * x + s * z)) < 1e-5
        ? [c * x + s * z, y, -s * x + c * z]
        : [c * x - s * z, y, s * x + c * z]
    const actual = twist.inverseAt(to, { near: [0, y + 0.01, 0] })
    assertClose(actual.position, from, 1e-9)
    const withoutNear = twist.inverseAt(to)
    assertClose(withoutNear.position, from, 1e-9)
  }
})

test('a wave that does not fold has one position, and is not folded', () => {
  const wave = warpOfX((x) => x.sin().mult(0.9))
  for (let i = -40; i <= 40; i++) {
    const from = i / 4
    const actual = wave.inverseAt([from + 0.9 * Math.sin(from), 1, -2])
    assertClose(actual.position, [from, 1, -2], 1e-9)
    assert.equal(actual.isFolded, false)
  }
})

describe('a wave that folds', () => {
  const wave = warpOfX((x) => x.sin().mult(-3))

  test('has several inverse positions, of which the option near selects one', () => {
    // x - 3 sin x is 0 at x = 0, where space is inside out, and at one position on each side.
    const side = 2.27886266
    for (const near of [0.1, 2.2, -2.2]) {
      const { position, isFolded } = wave.inverseAt([0, 0, 0], { near: [near, 0, 0] })
      assertClose(position, [Math.round(near / 2.2) * side, 0, 0], 1e-7)
      assert.equal(isFolded, near === 0.1)
    }
  })

  test('is inside out in the middle one of three layers', () => {
    const isFolded = (near) => wave.inverseAt([0.5, 0, 0], { near: [near, 0, 0] }).isFolded
    assert.deepEqual([-2, 0, 2.4].map(isFolded), [false, true, false])
  })

  test('is inverted from every start', () => {
    for (let i = -30; i <= 30; i++) {
      const { position } = wave.inverseAt([i / 3, 0, 0])
      assert.ok(Math.abs(position[0] - 3 * Math.sin(position[0]) - i / 3) < 1e-9)
    }
  })
})

test('a mirror is inside out everywhere, though it moves only one position to each point', () => {
  const mirror = warpOfX((x) => x.mult(-2))
  for (const near of [-9, 0, 5]) {
    const { position, isFolded } = mirror.inverseAt([3, 1, 2], { near: [near, 0, 0] })
    assertClose(position, [-3, 1, 2], 1e-12)
    assert.equal(isFolded, true)
  }
})

test('there is no result for a point that nothing is moved to', () => {
  const parabola = warpOfX((x) => x.mult(x))
  assert.equal(parabola.inverseAt([-1, 0, 0]), undefined)
  assertClose(parabola.inverseAt([0.75, 0, 0], { near: [1, 0, 0] }).position, [0.5, 0, 0], 1e-9)
  const flat = compileWarp(({ glsl, position }) => glsl.vec3(0, position.y().mult(-1), 0))
  assert.equal(flat.inverseAt([1, 1, 1]), undefined)
})

test('uniforms can be values or functions, and other inputs can be passed', () => {
  const moving = compileWarp(
    ({ glsl, normal, millis, uniforms: { amount } }) =>
      normal.mult(amount).add(glsl.vec3(millis.div(1000), 0, 0)),
    { uniforms: { amount: 2 } },
  )
  const { position } = moving.inverseAt([5, 5, 5], { normal: [0, 1, 0], uniforms: { millis: 500 } })
  assertClose(position, [4.5, 3, 5], 1e-12)
  const other = { normal: [0, 1, 0], uniforms: { millis: 0, amount: 1 } }
  assertClose(moving.inverseAt([5, 5, 5], other).position, [5, 4, 5], 1e-12)
})

test('invalid arguments throw', () => {
  const rejects = (work, message) => assert.throws(work, { name: 'WarpError', message })
  rejects(
    () => twist.inverseAt([1, 2]),
    /^inverseAt: expected an array of 3 finite numbers for the point, got an array of 2/,
  )
  rejects(
    () => twist.inverseAt([1, 2, NaN]),
    /^inverseAt: expected .* for the point, got one with NaN/,
  )
  rejects(
    () => twist.inverseAt([1, 2, 3], { near: 4 }),
    /^inverseAt: expected an array of 3 finite numbers for near, got the number 4/,
  )
  rejects(() => twist.inverseAt([1, 2, 3], { from: [0, 0, 0] }), /^inverseAt: .*from/)
  rejects(() => twist.inverseAt([1, 2, 3], { uniforms: { speed: 1 } }), /no uniform "speed"/)
  const alongNormal = compileWarp(({ normal }) => normal.mult(2))
  rejects(() => alongNormal.inverseAt([1, 2, 3]), /^inverseAt: the warp reads the normal/)
  const flat = compileWarp(({ normal }) => normal, { normals: false })
  rejects(() => flat.inverseAt([1, 2, 3]), /^inverseAt: .*normals: false/)
})

/** x + y², y + xz, z + x²: it folds, and moves far positions farther away. */
const quadratic = compileWarp(({ glsl, position: { x, y, z } }) =>
  glsl.vec3(y.mult(y), x.mult(z), x.mult(x)),
)
const quadraticOf = ([x, y, z]) => [x + y * y, y + x * z, z + x * x]

const sizeOf = (numbers) => Math.hypot(...numbers)

/** Checks that a warp moves a position to the target, within the documented bound. `placeOf` evaluates the warp in double precision. */
function assertReaches(placeOf, position, target, slack = 1) {
  const error = sizeOf(placeOf(position).map((x, i) => x - target[i]))
  const bound = 1e-9 * sizeOf(target) + 1e-14 * Math.min(sizeOf(position), 1e4)
  assert.ok(error <= slack * bound, `${position} is moved to ${placeOf(position)}, not ${target}`)
}

test('a result is moved to the target, also by a warp that leads the search far away', () => {
  const target = [1.3524719, 2.9967473, 2.3314333]
  assertReaches(quadraticOf, quadratic.inverseAt(target).position, target)
  let foundCount = 0
  for (let i = 0; i < 200; i++) {
    const from = [0, 1, 2].map((k) => 3 * Math.sin(1.7 * i * (k + 1) + k))
    const target = quadraticOf(from)
    const inverse = quadratic.inverseAt(target)
    if (!inverse) continue
    foundCount++
    assertReaches(quadraticOf, inverse.position, target)
  }
  assert.ok(
    foundCount > 190,
    `${foundCount} of 200 targets have a result, though all have an inverse`,
  )
})

test('a start far away does not make a wrong result acceptable', () => {
  const square = warpOfX((x) => x.mult(x).sub(x))
  for (const near of [1, 1e3, 1e6, 1e9, 1e12, 1e20, -1e30]) {
    assert.equal(square.inverseAt([-1e-3, 0, 0], { near: [near, near, near] }), undefined)
    const target = [4, 5, 6]
    const inverse = square.inverseAt(target, { near: [near, -near, near] })
    assertClose([Math.abs(inverse.position[0]), ...inverse.position.slice(1)], [2, 5, 6], 1e-8)
  }
})

describe('random warps, targets and starts', () => {
  const randomOf = (seed) => () => ((seed = (seed * 1664525 + 1013904223) >>> 0), seed / 2 ** 32)
  /** Each kind makes an offset and, independently, `placeOf`, which returns the warped position in double precision. */
  const kinds = {
    quadratic(randomNumber, size) {
      const rows = [0, 1, 2].map(() => Array.from({ length: 6 }, () => randomNumber(0.7)))
      const products = ([x, y, z], times) =>
        [
          [x, x],
          [y, y],
          [z, z],
          [x, y],
          [x, z],
          [y, z],
        ].map(([a, b]) => times(a, b))
      return {
        offset: ({ glsl, position: p }) => {
          const all = products([p.x, p.y, p.z], (a, b) => a.mult(b).div(size))
          const sums = rows.map((row) =>
            row.map((k, i) => all[i].mult(k)).reduce((a, b) => a.add(b)),
          )
          return glsl.vec3(...sums)
        },
        placeOf(p) {
          const all = products(p, (a, b) => (a * b) / size)
          return rows.map((row, i) => p[i] + row.reduce((sum, k, j) => sum + k * all[j], 0))
        },
      }
    },
    'folding waves'(randomNumber, size) {
      const rows = [0, 1, 2].map(() => [
        randomNumber(3),
        randomNumber(3),
        randomNumber(3),
        randomNumber(6),
        randomNumber(2),
      ])
      return {
        offset: ({ glsl, position: p }) =>
          glsl.vec3(
            ...rows.map(([a, b, c, d, height]) =>
              p.x
                .mult(a / size)
                .add(p.y.mult(b / size), p.z.mult(c / size), d)
                .sin()
                .mult(height * size),
            ),
          ),
        placeOf: (p) =>
          rows.map(
            ([a, b, c, d, height], i) =>
              p[i] + height * size * Math.sin((a * p[0] + b * p[1] + c * p[2]) / size + d),
          ),
      }
    },
  }
  for (const [kind, make] of Object.entries(kinds))
    for (const size of [1, 1e5, 1e-6])
      test(`${kind} of size ${size}`, () => {
        const random = randomOf(7 + Math.round(size))
        const randomNumber = (max) => max * (2 * random() - 1)
        const randomPoint = (max) => [randomNumber(max), randomNumber(max), randomNumber(max)]
        let foundCount = 0
        for (let i = 0; i < 30; i++) {
          const { offset, placeOf } = make(randomNumber, size)
          const warp = compileWarp(offset)
          for (let k = 0; k < 4; k++) {
            const target = placeOf(randomPoint(2 * size))
            const near = [
              undefined,
              randomPoint(2 * size),
              randomPoint(50 * size),
              randomPoint(1e9),
            ][k]
            const inverse = warp.inverseAt(target, { near })
            if (!inverse) continue
            foundCount++
            // `placeOf` rounds differently from the warp.
            assertReaches(placeOf, inverse.position, target, 2)
          }
        }
        assert.ok(
          foundCount > 110,
          `${foundCount} of 120 targets have a result, though all have an inverse`,
        )
      })
})
