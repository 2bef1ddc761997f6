// `tslOffset` makes offset functions from functions in TSL: evaluates these on the CPU, and tests messages.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import * as TSL from 'three/tsl'
import { exactNormals, tslOffset, warp } from '../../dist/three.webgpu.js'
import { compileWarp } from '../../dist/warpjet.js'
import { noise } from '../support/browser/three/exact-normals/materialx.js'

const { Fn, Loop, float, mx_noise_float, normalLocal, sin, time, uniform, uniformArray, uv, vec3 } =
  TSL

const assertNear = (actual, expected, tolerance = 1e-5) =>
  expected.forEach((x, i) =>
    assert.ok(Math.abs(actual[i] - x) < tolerance, `expected ${expected}, got ${actual}`),
  )

test('time is millis in seconds, and uniforms have their current values', () => {
  const height = uniform(0.3).setName('height')
  const wave = tslOffset((p) => vec3(0, sin(p.x.mul(3).add(time)).mul(height), 0))
  assert.deepEqual(Object.keys(wave.uniforms), ['height'])
  const warped = compileWarp(wave, { uniforms: wave.uniforms })
  const vertices = { positions: [1, 0, 0], normals: [0, 1, 0] }
  for (const value of [0.3, 0.6]) {
    height.value = value
    const { positions, normals } = warped.evaluate(vertices, { uniforms: { millis: 500 } })
    assertNear(positions, [1, value * Math.sin(3.5), 0])
    const slope = 3 * value * Math.cos(3.5)
    assertNear(normals, [-slope / Math.hypot(slope, 1), 1 / Math.hypot(slope, 1), 0])
  }
  assert.ok(
    warped.bounds({ min: [-1, 0, 0], max: [1, 0, 0] }, { uniforms: { millis: 500 } }).max[1] >=
      0.59,
  )
})

test('MaterialX noise has the values of its specification', () => {
  const moved = compileWarp(tslOffset((p) => vec3(0, 0, mx_noise_float(p.mul(2)))))
  for (const p of [
    [0.3, 0.2, 0.1],
    [-1.7, 4.1, 2.6],
  ])
    assertNear(moved.evaluate({ positions: p }).positions, [
      p[0],
      p[1],
      p[2] + noise(p.map((x) => 2 * x)),
    ])
})

test('vectors, colours, matrices and arrays are uniforms', () => {
  const shift = uniform(new THREE.Vector3(1, 2, 3))
  const tint = uniform(new THREE.Color(0.5, 0, 0))
  const matrix = uniform(new THREE.Matrix3().set(2, 0, 0, 0, 3, 0, 0, 0, 4))
  const list = uniformArray([5, 7, 11])
  const offset = tslOffset((p) =>
    Fn(() => {
      const sum = float(0).toVar()
      Loop(3, ({ i }) => {
        sum.addAssign(list.element(i))
      })
      return matrix.mul(p).add(shift).add(tint).add(sum).add(list.element(1))
    })(),
  )
  const { positions } = compileWarp(offset, { uniforms: offset.uniforms }).evaluate({
    positions: [1, 1, 1],
  })
  assertNear(positions, [1 + 2 + 1 + 0.5 + 30, 1 + 3 + 2 + 30, 1 + 4 + 3 + 30])
})

test('an unnamed uniform never gets the name of another, such as uniform1', () => {
  const [named, unnamed, other] = [0.5, 0.25, 0.125].map((value) => uniform(value))
  named.setName('uniform1')
  const offset = tslOffset((p) => vec3(named, unnamed, other).mul(p))
  assert.equal(Object.keys(offset.uniforms).length, 3)
  const { positions } = compileWarp(offset, { uniforms: offset.uniforms }).evaluate({
    positions: [1, 1, 1],
  })
  assertNear(positions, [1.5, 1.25, 1.125])
})

test("returns: 'position' works, and the function may read normalLocal and uv()", () => {
  const { positions } = compileWarp(
    tslOffset((p) => p.add(normalLocal.mul(uv().x)), { returns: 'position' }),
    { surfaceVariation: false },
  ).evaluate({ positions: [1, 2, 3], normals: [0, 0, 1], uvs: [0.5, 0] })
  assertNear(positions, [1, 2, 3.5])
})

test('warp accepts a tslOffset with its uniforms, and throws without them', () => {
  const height = uniform(0.2)
  const wave = tslOffset((p) => vec3(0, sin(p.x).mul(height), 0))
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(1, 8, 6), new THREE.MeshNormalMaterial())
  const warped = warp(mesh, wave, { uniforms: wave.uniforms })
  assert.ok(warped.bounds().max.y > 1)
  warped.dispose()
  assert.throws(
    () => warp(mesh, wave),
    /tslOffset: the function reads uniforms of TSL.*offset\.uniforms/,
  )
})

/** A sum of sin(2 x + i / 100) / 1000 over that many terms, up to a uniform. */
function sumTo(end, options, numbers = 1) {
  const count = uniform(end)
  return tslOffset(
    (p) =>
      Fn(() => {
        const sums = Array.from({ length: numbers }, () => float(0).toVar())
        Loop({ type: 'float', start: float(0), end: count }, ({ i }) => {
          for (const sum of sums) sum.addAssign(sin(p.x.mul(2).add(i.mul(0.01))).mul(0.001))
        })
        return vec3(0, sums[0], sums.at(-1))
      })(),
    options,
  )
}
const sumAt = (x, count) =>
  Array.from({ length: count }, (_, i) => 0.001 * Math.sin(2 * x + 0.01 * i)).reduce(
    (sum, term) => sum + term,
    0,
  )

test('a loop up to a uniform has a value on the CPU if it ends after 256 iterations, or maxIterations', () => {
  const heightAt = (offset) =>
    compileWarp(offset, { uniforms: offset.uniforms }).evaluate({ positions: [0.3, 0, 0] })
      .positions[1]
  for (const count of [0, 1, 200, 256])
    assertNear([heightAt(sumTo(count))], [sumAt(0.3, count)], 1e-6)
  assert.ok(Number.isNaN(heightAt(sumTo(257))))
  assertNear([heightAt(sumTo(1000, { maxIterations: 1000 }))], [sumAt(0.3, 1000)], 1e-6)
  assertNear([heightAt(sumTo(1000, { maxIterations: 90 }))], [sumAt(0.3, 90)], 1e-6)
  const offset = sumTo(1000)
  const { code } = compileWarp(offset, { uniforms: offset.uniforms })
  assert.match(code, /\w+ < 4194304;/)
  assert.ok(code.length < 2000, `${code.length} characters`)
})

test('a loop that cannot stay a loop is cut off with a message, once', (t) => {
  const warn = t.mock.method(console, 'warn', () => {})
  const offset = sumTo(300, {}, 33)
  assert.deepEqual(
    warn.mock.calls.map(({ arguments: [text] }) => text.split('\n')[0].replace(/\d+/g, 'N')),
    [
      "tslOffset: only the shader knows where this loop ends, and it can't stay a loop there, since it changes more than about N numbers or is nested more than N deep, so it is cut off after N iterations; let it change fewer numbers, such as a shorter array, or set the option maxIterations (N to N).",
    ],
  )
  const { positions } = compileWarp(offset, { uniforms: offset.uniforms }).evaluate({
    positions: [0.3, 0, 0],
  })
  assertNear(positions.slice(1), [sumAt(0.3, 256), sumAt(0.3, 256)])
  sumTo(300, { maxIterations: 300 }, 33)
  assert.equal(warn.mock.callCount(), 1)
})

test('messages of tslOffset', () => {
  for (const [work, message] of [
    [() => 3, /^tslOffset: expected a node that is a vec3 for the function, got the number 3\.$/],
    [3, /^tslOffset: expected a function, got the number 3/],
    [() => TSL.cameraPosition, /reads a UniformNode that three\.js computes/],
    [() => TSL.positionWorld, /reads a ModelNode that three\.js computes/],
    [() => vec3(TSL.instanceIndex), /reads an IndexNode/],
    [() => vec3(TSL.vertexIndex), /depends on vertexIndex/],
    [() => TSL.attribute('shift', 'vec3'), /reads the attribute "shift"/],
    [() => vec3(TSL.instancedArray(4, 'float').element(2)), /reads a StorageArrayElementNode/],
    [() => vec3(TSL.screenUV, 0), /reads a ScreenNode/],
    [() => vec3(TSL.fwidth(TSL.positionLocal.x)), /depends on fwidth\(\)/],
    [() => vec3(TSL.deltaTime), /reads a UniformNode/],
  ])
    assert.throws(() => tslOffset(work), { name: 'WarpError', message })
  assert.throws(() => tslOffset(() => vec3(0), { maxIterations: 5000 }), {
    message:
      /^tslOffset: expected a whole number from 1 to 4096 for the option "maxIterations", got the number 5000/,
  })
})

test('messages of exactNormals', () => {
  const node = { isMaterial: true, isNodeMaterial: true, type: 'MeshStandardNodeMaterial' }
  for (const [material, options, message] of [
    [undefined, {}, /^exactNormals: expected a node material, .* got undefined/],
    [new THREE.MeshBasicMaterial(), {}, /expected a node material, .* got a MeshBasicMaterial/],
    [node, {}, /expected a material with a positionNode, got one without/],
    [{ ...node, vertexNode: {} }, {}, /a vertexNode, which replaces the position/],
    [{ ...node, positionNode: {} }, { normals: 'pixels' }, /the option "normals"/],
    [{ ...node, positionNode: {} }, { maxIterations: 0.5 }, /from 1 to 4096 for the option/],
  ])
    assert.throws(() => exactNormals(material, options), { name: 'WarpError', message })
})
