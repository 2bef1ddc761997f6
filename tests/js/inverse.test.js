// inverseAt: where a warp brings a point from, against inverses by hand.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'

const twist = compileWarp(({ glsl, position }) =>
  glsl.rotateY(position.y().mult(2)).mult(position).sub(position),
)

/** x by an offset of x alone. */
const along = (offset) =>
  compileWarp(({ glsl, position }) => glsl.vec3(offset(position.x(), glsl), 0, 0))

const isClose = (found, expected, bound) =>
  assert.ok(
    Math.hypot(...found.map((x, i) => x - expected[i])) <= bound,
    `${found} is not ${expected}`,
  )

test('a twist is undone by the twist back, from anywhere', () => {
  for (let i = 0; i < 500; i++) {
    const from = [Math.sin(i), Math.cos(2.1 * i), Math.sin(3.7 * i + 1)].map((x) => 3 * x)
    const [x, y, z] = from
    const [c, s] = [Math.cos(2 * y), Math.sin(2 * y)]
    // Of a rotation about y either way round, the one that evaluateAt has.
    const [moved] = twist.evaluateAt(from).position
    const to =
      Math.abs(moved - (c * x + s * z)) < 1e-5
        ? [c * x + s * z, y, -s * x + c * z]
        : [c * x - s * z, y, s * x + c * z]
    const found = twist.inverseAt(to, { near: [0, y + 0.01, 0] })
    isClose(found.position, from, 1e-9)
    const alone = twist.inverseAt(to)
    isClose(alone.position, from, 1e-9)
  }
})

test('a wave that does not fold has one place, and says so', () => {
  const wave = along((x) => x.sin().mult(0.9))
  for (let i = -40; i <= 40; i++) {
    const from = i / 4
    const found = wave.inverseAt([from + 0.9 * Math.sin(from), 1, -2])
    isClose(found.position, [from, 1, -2], 1e-9)
    assert.equal(found.isFolded, false)
  }
})

describe('a wave that folds', () => {
  const wave = along((x) => x.sin().mult(-3))

  test('has several, of which near chooses', () => {
    // x - 3 sin x = 0 at 0, inside out there, and on both sides of it.
    const side = 2.27886266
    for (const near of [0.1, 2.2, -2.2]) {
      const { position, isFolded } = wave.inverseAt([0, 0, 0], { near: [near, 0, 0] })
      isClose(position, [Math.round(near / 2.2) * side, 0, 0], 1e-7)
      assert.equal(isFolded, near === 0.1)
    }
  })

  test('has one layer of three that is inside out, between two that are not', () => {
    const isFolded = (near) => wave.inverseAt([0.5, 0, 0], { near: [near, 0, 0] }).isFolded
    assert.deepEqual([-2, 0, 2.4].map(isFolded), [false, true, false])
  })

  test('is reached from everywhere', () => {
    for (let i = -30; i <= 30; i++) {
      const { position } = wave.inverseAt([i / 3, 0, 0])
      assert.ok(Math.abs(position[0] - 3 * Math.sin(position[0]) - i / 3) < 1e-9)
    }
  })
})

test('a mirror is inside out everywhere, though one place alone comes to each point', () => {
  const mirror = along((x) => x.mult(-2))
  for (const near of [-9, 0, 5]) {
    const { position, isFolded } = mirror.inverseAt([3, 1, 2], { near: [near, 0, 0] })
    isClose(position, [-3, 1, 2], 1e-12)
    assert.equal(isFolded, true)
  }
})

test('where nothing comes, nothing is found', () => {
  const parabola = along((x) => x.mult(x))
  assert.equal(parabola.inverseAt([-1, 0, 0]), undefined)
  isClose(parabola.inverseAt([0.75, 0, 0], { near: [1, 0, 0] }).position, [0.5, 0, 0], 1e-9)
  const flat = compileWarp(({ glsl, position }) => glsl.vec3(0, position.y().mult(-1), 0))
  assert.equal(flat.inverseAt([1, 1, 1]), undefined)
})

test('uniforms by value and by call, and what else the offset reads', () => {
  const moving = compileWarp(
    ({ glsl, normal, millis, uniforms: { amount } }) =>
      normal.mult(amount).add(glsl.vec3(millis.div(1000), 0, 0)),
    { uniforms: { amount: 2 } },
  )
  const { position } = moving.inverseAt([5, 5, 5], { normal: [0, 1, 0], uniforms: { millis: 500 } })
  isClose(position, [4.5, 3, 5], 1e-12)
  const other = { normal: [0, 1, 0], uniforms: { millis: 0, amount: 1 } }
  isClose(moving.inverseAt([5, 5, 5], other).position, [5, 4, 5], 1e-12)
})

test('what is wrong is said in a sentence', () => {
  const refused = (work, message) => assert.throws(work, { name: 'WarpError', message })
  refused(
    () => twist.inverseAt([1, 2]),
    /^inverseAt: the point must be an array of 3 finite numbers/,
  )
  refused(() => twist.inverseAt([1, 2, NaN]), /^inverseAt: the point .*NaN/)
  refused(() => twist.inverseAt([1, 2, 3], { near: 4 }), /^inverseAt: near must be/)
  refused(() => twist.inverseAt([1, 2, 3], { from: [0, 0, 0] }), /^inverseAt: .*from/)
  refused(() => twist.inverseAt([1, 2, 3], { uniforms: { speed: 1 } }), /no uniform "speed"/)
  const alongNormal = compileWarp(({ normal }) => normal.mult(2))
  refused(() => alongNormal.inverseAt([1, 2, 3]), /^inverseAt: the warp reads the normal/)
  const flat = compileWarp(({ normal }) => normal, { normals: false })
  refused(() => flat.inverseAt([1, 2, 3]), /^inverseAt: .*normals: false/)
})
