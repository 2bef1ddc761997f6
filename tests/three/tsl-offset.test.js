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
})

test('messages of exactNormals', () => {
  const node = { isMaterial: true, isNodeMaterial: true, type: 'MeshStandardNodeMaterial' }
  for (const [material, options, message] of [
    [undefined, {}, /^exactNormals: expected a node material, .* got undefined/],
    [new THREE.MeshBasicMaterial(), {}, /expected a node material, .* got a MeshBasicMaterial/],
    [node, {}, /expected a material with a positionNode, got one without/],
    [{ ...node, vertexNode: {} }, {}, /a vertexNode, which replaces the position/],
    [{ ...node, positionNode: {} }, { normals: 'pixels' }, /the option "normals"/],
  ])
    assert.throws(() => exactNormals(material, options), { name: 'WarpError', message })
})
