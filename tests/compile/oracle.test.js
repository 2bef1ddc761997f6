// The oracle of tests/compile/normals.browser.test.js is correct: its finite differences agree with derivatives computed by hand.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { angleBetween, jacobian, warpVertex } from '../support/browser/oracle.js'

const { sin, cos } = Math

function assertClose(actual, expected, tolerance) {
  actual.flat().forEach((value, i) => {
    const difference = Math.abs(value - expected.flat()[i])
    assert.ok(difference < tolerance, `${value} is not ${expected.flat()[i]}`)
  })
}

const points = [
  [0, 0, 0],
  [57.7, -31.1, 99],
  [-100, 100, -12.5],
]

test('the partial derivatives of a twist are correct', () => {
  const twist = ([x, y, z]) => {
    const a = 0.02 * x + 98.765
    return [x, y * cos(a) - (z + 500) * sin(a), y * sin(a) + (z + 500) * cos(a) - 500]
  }
  for (const p of points) {
    const [x, y, z] = p
    const a = 0.02 * x + 98.765
    const byX = [
      1,
      0.02 * (-y * sin(a) - (z + 500) * cos(a)),
      0.02 * (y * cos(a) - (z + 500) * sin(a)),
    ]
    const expected = [byX, [0, cos(a), sin(a)], [0, -sin(a), cos(a)]]
    assertClose(jacobian(twist, p, 0.1), expected, 1e-9)
  }
})

test('the partial derivatives of sines are correct', () => {
  const sines = ([x, y, z]) => [0.05 * sin(2 + 20 * y), 0.05 * sin(1 + 10 * z), 0.05 * sin(15 * x)]
  for (const p of points.map((point) => point.map((value) => value / 100))) {
    const [x, y, z] = p
    const expected = [
      [0, 0, 0.75 * cos(15 * x)],
      [cos(2 + 20 * y), 0, 0],
      [0, 0.5 * cos(1 + 10 * z), 0],
    ]
    assertClose(jacobian(sines, p, 0.001), expected, 1e-9)
  }
})

test('the oracle returns no partial derivatives at or near a kink or a jump', () => {
  const functions = {
    kink: ([x]) => [Math.abs(x), 0, 0],
    jump: ([x, y]) => [0, Math.sign(x) * y, 0],
    'bend of the slope': ([x]) => [x * Math.abs(x), 0, 0],
  }
  for (const [name, f] of Object.entries(functions)) {
    for (const x of [0, 3e-4, -8e-4]) assert.equal(jacobian(f, [x, 0, 0], 1e-3), null, name)
    for (const x of [2e-3, -2e-3]) assert.notEqual(jacobian(f, [x, 0, 0], 1e-3), null, name)
  }
})

test('the normals of a sphere that becomes an ellipsoid are correct', () => {
  // x²/4 + y² + z²/9 = 1 has a normal along its gradient, (x/2, 2y, 2z/9).
  const stretch = ([x, , z]) => [x, 0, 2 * z]
  for (const p of [
    [1, 0, 0],
    [0.6, 0, -0.8],
    [0.48, 0.6, 0.64],
  ]) {
    const { position, normal } = warpVertex(stretch, { position: p, normal: p }, {}, 1e-3)
    const [x, y, z] = position
    assert.ok(angleBetween(normal, [x / 2, 2 * y, (2 * z) / 9]) < 1e-9)
  }
})

test('a flattened surface has the normal of the plane, or none', () => {
  const flatten = ([x]) => [-x, 0, 0]
  const normalOf = (normal) =>
    warpVertex(flatten, { position: [1, 2, 3], normal }, {}, 1e-3).normal.map((x) => x + 0)
  assertClose(normalOf([0.6, 0.8, 0]), [1, 0, 0], 1e-12)
  assertClose(normalOf([-3, 4, 0]), [-1, 0, 0], 1e-12)
  assert.deepEqual(normalOf([0, 0.6, 0.8]), [0, 0, 0])
  assert.deepEqual(normalOf([0, 0, 0]), [0, 0, 0])
})
