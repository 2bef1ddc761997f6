// Compares the formulas in the paper, the article and the documentation of p5.warp and glsl-autodiff, compiled by warpjet, with plain
// JavaScript functions and their finite differences. The article is "Deforming 3D shapes in real time" (2021), the paper
// "Vertex Shader Domain Warping with Automatic Differentiation" (2024).
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { gen } from '../../dist/autodiff.js'
import { compileWarp } from '../../dist/warpjet.js'
import { runGlsl } from '../glsl/run.js'
import { add, cross, normalize, subtract } from '../support/browser/matrix.js'
import { angleBetween, distanceBetween, warpVertex } from '../support/browser/oracle.js'
import { warps } from '../warps/listings.js'
import { seededRandom } from '../warps/random.js'

const { sin, cos } = Math

const random = seededRandom(11)
const between = (low, high) => low + (high - low) * random()
const zip = (f, ...vectors) => vectors[0].map((_, i) => f(...vectors.map((v) => v[i])))
const anyPoint = (size) => [0, 1, 2].map(() => between(-size, size))

function assertClose(actual, expected, tolerance) {
  for (const [i, value] of [actual].flat().entries()) {
    const expectedValue = [expected].flat()[i]
    assert.ok(Math.abs(value - expectedValue) <= tolerance, `${actual} is not ${expected}`)
  }
}

/** Requests a vector or number and its derivatives with respect to the coordinates of `position`. */
function outputAll(result, position) {
  result.output('value')
  for (const axis of ['x', 'y', 'z']) result.outputDeriv(`by_${axis}`, position[axis]())
}

describe('the article:', () => {
  test('the derivative of its example, a tenth of a squared sine, is correct', () => {
    const code = gen((ad) => {
      const x = ad.param('x')
      const wave = x.mult(10).add(20).sin().pow(2).mult(0.1)
      wave.output('wave')
      wave.outputDeriv('slope', x)
    })
    for (const x of [-3.1, -0.4, 0, 0.25, 2]) {
      const { wave, slope } = runGlsl(code, { x })
      const angle = 10 * x + 20
      assertClose([wave, slope], [0.1 * sin(angle) ** 2, 2 * sin(angle) * cos(angle)], 1e-7)
    }
  })

  test('the chain rule holds: the derivative of sin(u) is cos(u) times that of u', () => {
    const code = gen((ad) => {
      const x = ad.param('x')
      const u = x.pow(3).sub(x.mult(2))
      u.outputDeriv('du', x)
      u.sin().outputDeriv('dsin', x)
    })
    for (const x of [-1.2, 0, 0.5, 2]) {
      const { du, dsin } = runGlsl(code, { x })
      assertClose([du, dsin], [3 * x * x - 2, cos(x ** 3 - 2 * x) * (3 * x * x - 2)], 1e-7)
    }
  })

  // glsl-autodiff's README begins with the same example.
  test('a plane moved by nested sines has the normal of its two tangents', () => {
    const code = gen((ad) => {
      const [x, y, time] = [ad.param('x'), ad.param('y'), ad.param('time')]
      const angle = (height) => ad.sum(height.mult(0.5), x.mult(1.5), y.mult(2.8), time.mult(0.002))
      let height = ad.val(0)
      for (let i = 0; i < 3; i++) height = height.add(angle(height).sin())
      const z = height.mult(0.1)
      z.output('z')
      z.outputDeriv('dzdx', x)
      z.outputDeriv('dzdy', y)
    })
    const offset = ([x, y], { time }) => {
      let height = 0
      for (let i = 0; i < 3; i++) height += sin(height / 2 + 1.5 * x + 2.8 * y + 0.002 * time)
      return [0, 0, height / 10]
    }
    for (const time of [0, 1234, 98765])
      for (let i = 0; i < 20; i++) {
        const [x, y] = anyPoint(2)
        const { z, dzdx, dzdy } = runGlsl(code, { x, y, time })
        const vertex = { position: [x, y, 0], normal: [0, 0, 1] }
        const { position, normal } = warpVertex(offset, vertex, { time }, 1e-3)
        assertClose([x, y, z], position, 1e-7)
        assertClose(normalize(cross([1, 0, dzdx], [0, 1, dzdy])), normal, 1e-7)
      }
  })

  test('a height that depends on x and y moves a plane', () => {
    const code = gen((ad) => {
      const position = ad.vec3Param('position')
      const height = position.x().mult(3).sin().mult(position.y().mult(2).cos()).mult(0.2)
      outputAll(height, position)
      ad.vec3(0, 0, height).adjustNormal(ad.vec3Param('normal'), position).output('adjusted')
    })
    for (let i = 0; i < 20; i++) {
      const [x, y, z] = anyPoint(2)
      const results = runGlsl(code, { position: [x, y, z], normal: [0, 0, 1] })
      assertClose(results.value, 0.2 * sin(3 * x) * cos(2 * y), 1e-7)
      assertClose(results.by_x, 0.6 * cos(3 * x) * cos(2 * y), 1e-7)
      assertClose(results.by_y, -0.4 * sin(3 * x) * sin(2 * y), 1e-7)
      assert.equal(results.by_z, 0)
      const tangents = [
        [1, 0, results.by_x],
        [0, 1, results.by_y],
      ]
      assertClose(results.adjusted, normalize(cross(...tangents)), 1e-7)
    }
  })

  test('an offset in three dimensions has the right tangents along x and along (y, z)', () => {
    const code = gen((ad) => {
      const position = ad.vec3Param('position')
      const [x, y, z] = [position.x(), position.y(), position.z()]
      const shift = ad.vec3(y.mult(z).sin(), x.add(z.mult(2)).cos(), x.mult(y).mult(0.5))
      outputAll(shift, position)
    })
    const move = ([x, y, z]) => add([x, y, z], [sin(y * z), cos(x + 2 * z), 0.5 * x * y])
    const along = (u, p) => {
      const at = (h) => move(p.map((value, i) => value + h * u[i]))
      return subtract(at(1e-4), at(-1e-4)).map((rise) => rise / 2e-4)
    }
    for (let i = 0; i < 20; i++) {
      const position = anyPoint(1.5)
      const { by_x, by_y, by_z } = runGlsl(code, { position })
      assertClose(add([1, 0, 0], by_x), along([1, 0, 0], position), 1e-6)
      assertClose(add([0, 1, 1], add(by_y, by_z)), along([0, 1, 1], position), 1e-6)
    }
  })
})

/** Returns random points with unit normals, some of which are along an axis, at several times. */
function vertices(size) {
  const alongAxes = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, 0, -1],
  ]
  const oblique = Array.from({ length: 20 }, () => normalize(anyPoint(1)))
  const at = (millis) => (normal) => ({ position: anyPoint(size), normal, millis })
  return [0, 1234, 98765].flatMap((millis) => [...alongAxes, ...oblique].map(at(millis)))
}

/** Returns two perpendicular tangents of length 1 with u × v = n, as in the paper. */
function tangents(n) {
  const w = n[1] === 0 && n[2] === 0 ? [0, 1, 0] : [1, 0, 0]
  const v = normalize(cross(w, n))
  return [cross(v, n), v]
}

describe('positions and normals:', () => {
  for (const [name, { warp, offset, size }] of Object.entries(warps))
    test(name, () => {
      const { code } = compileWarp(warp)
      const all = vertices(size)
      let smooth = 0
      for (const vertex of all) {
        const expected = warpVertex(offset, vertex, vertex, 1e-4 * size)
        const { warpedPosition, warpedNormal } = runGlsl(code, vertex)
        assert.ok(distanceBetween(warpedPosition, expected.position) < 1e-5 * size)
        if (!expected.normal) continue
        smooth++
        const angle = angleBetween(warpedNormal, expected.normal)
        assert.ok(angle < 1e-4 * expected.sensitivity, `${angle}° at ${vertex.position}`)
      }
      assert.ok(smooth > 0.8 * all.length, `${smooth} of ${all.length} points are smooth`)
    })
})

describe('the paper:', () => {
  const toCode = (warp) =>
    gen((ad) => {
      const [position, millis] = [ad.vec3Param('position'), ad.param('millis')]
      outputAll(warp({ glsl: ad, position, millis }), position)
    })

  test('the Jacobian of its example has nonzero entries only in the column of y', () => {
    const code = toCode(warps['the paper: its example of an offset'].warp)
    for (const [y, millis] of [
      [0, 0],
      [0.3, 250],
      [-1.7, 98765],
    ]) {
      const { value, by_x, by_y, by_z } = runGlsl(code, { position: [9, y, 9], millis })
      const angle = 0.005 * millis + 2 * y
      assertClose(value, [0.5 * sin(angle), 0, 0], 1e-7)
      assertClose(by_y, [cos(angle), 0, 0], 1e-7)
      assertClose([by_x, by_z].flat(), new Array(6).fill(0), 0)
    }
  })

  test('a flattened mesh has normals only on the sides that remain visible', () => {
    const { code } = compileWarp(({ glsl, position }) => glsl.vec3(position.x().neg(), 0, 0))
    const normalOf = (normal) => runGlsl(code, { position: [1, 2, 3], normal }).warpedNormal
    assertClose(normalOf([-0.6, 0.8, 0]), [-1, 0, 0], 1e-12)
    assertClose(normalOf([0, 0.6, 0.8]), [0, 0, 0], 0)
  })

  for (const [name, { warp, size }] of Object.entries(warps))
    test(`its equation for a normal holds for any tangents: ${name}`, () => {
      const [columns, { code }] = [toCode(warp), compileWarp(warp)]
      for (const vertex of vertices(size)) {
        const { by_x, by_y, by_z } = runGlsl(columns, vertex)
        const { warpedNormal } = runGlsl(code, vertex)
        const move = (u) =>
          zip((t, x, y, z) => t + x * u[0] + y * u[1] + z * u[2], u, by_x, by_y, by_z)
        const [u, v] = tangents(vertex.normal)
        for (const [a, b] of [
          [u, v],
          [v, u.map((x) => -x)],
          [zip((x, y) => x + 2 * y, u, v), zip((x, y) => 3 * x + 7 * y, u, v)],
        ])
          assertClose(normalize(cross(move(a), move(b))), warpedNormal, 1e-6)
      }
    })
})

test('the wobble of p5.warp needs 9 sines and 6 cosines, including derivatives', () => {
  const { code } = compileWarp(warps['the examples of p5.warp: the wobble'].warp)
  const count = (name) => code.match(new RegExp(`\\b${name}\\(`, 'g')).length
  assert.ok(count('sin') <= 9 && count('cos') <= 6, `${count('sin')} sin, ${count('cos')} cos`)
})
