// Tests in which frames of a motion `createDetail` measures a mesh, and that the others are as exact.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { createDetail } from 'warpjet/detail'
import { details } from '../../dist/memory.js'
import { arraysOf, viewFrom } from '../support/detail-error.js'
import { quantile, screenErrors } from '../support/screen-error.js'

const waves = compileWarp(
  ({ glsl, position: p, uniforms }) => {
    const height = p.x().mult(4).add(uniforms.time).sin().mult(p.y().mult(3).cos())
    return glsl.vec3(0, 0, height.mult(0.2))
  },
  { normals: false, uniforms: { time: 0 } },
)
const mesh = arraysOf(new THREE.PlaneGeometry(2, 2, 6, 6))
const still = viewFrom([1, -2, 3])
/** The number of frames in which a mesh was measured. */
let measured = 0
const wasm = details.get()
const { _detail_update: update } = wasm
wasm._detail_update = (...args) => {
  measured++
  return update(...args)
}

/** Returns a moving mesh. Its `step` moves to a time, seen by a view, and returns whether the triangles changed. */
function start() {
  const detail = createDetail(mesh, waves)
  const frame = { time: 0, view: still }
  const warpPositions = (vertices) =>
    waves.evaluate(vertices, { uniforms: { time: frame.time } }).positions
  return {
    step(time, view = still) {
      Object.assign(frame, { time, view })
      return detail.update(view, { uniforms: { time } })
    },
    /** Returns the distance from the warped surface, in pixels, that 99.9% of the points do not exceed. */
    error() {
      const [positions, indices] = [detail.positions.slice(), detail.indices.slice()]
      const all = Array.from({ length: indices.length / 3 }, (_, t) => t)
      const divided = { positions, normals: positions, indices }
      return quantile(screenErrors(divided, warpPositions, frame.view, all), 0.999)
    },
  }
}

const moves = {
  'a moving surface': (i) => [0.01 * i],
  'a moving camera': (i) => [0, viewFrom([1, -2, 3 - 0.005 * i])],
  both: (i) => [0.01 * i, viewFrom([1, -2, 3 - 0.005 * i])],
}
for (const [name, at] of Object.entries(moves))
  test(`${name} is measured in about every second frame, and all are exact`, (t) => {
    const { step, error } = start()
    measured = 0
    let changes = 0
    for (let i = 0; i < 80; i++) {
      if (step(...at(i))) changes++
      assert.ok(error() <= 1, `frame ${i}: ${error()} pixels`)
    }
    t.diagnostic(`${measured} of 80 frames are measured, ${changes} change the mesh`)
    assert.ok(measured >= 40 && measured <= 55, `${measured} of 80 frames`)
    assert.ok(changes > 2, `${changes} changes`)
  })

test('a step that is longer than the one before changes the triangles at once', () => {
  for (let length = 20; length < 24; length++) {
    const { step, error } = start()
    for (let i = 0; i < length; i++) step(0.02 * i)
    assert.ok(step(0.02 * length + 0.8))
    assert.ok(error() <= 1, `${error()} pixels`)
    assert.ok(step(0.02 * length + 0.8, viewFrom([0.5, -0.8, 1])))
    assert.ok(error() <= 1, `${error()} pixels`)
  }
})

test('the end of a motion is measured', () => {
  for (let length = 20; length < 24; length++) {
    const { step } = start()
    for (let i = 0; i < length; i++) step(0.01 * i)
    measured = 0
    for (let i = 0; i < 8; i++) step(0.01 * length)
    assert.equal(measured, 1)
  }
})

test('states that alternate are measured in each frame', () => {
  const { step, error } = start()
  for (let i = 0; i < 12; i++) {
    step(0.8 * (i % 2))
    assert.ok(error() <= 1, `frame ${i}: ${error()} pixels`)
  }
})

test('large steps are measured in each frame', () => {
  const { step, error } = start()
  for (let i = 0; i < 12; i++) {
    // Each step moves the crests by a tenth of a wave, and shows another half of the plane.
    step(0.6 * i, i % 2 ? viewFrom([1, 0, 1], [1, 0, 0]) : viewFrom([-1, 0, 1], [-1, 0, 0]))
    assert.ok(error() <= 1, `frame ${i}: ${error()} pixels`)
  }
})

test('a tolerance that changes within a steady motion counts at once', () => {
  for (let length = 20; length < 24; length++) {
    const detail = createDetail(mesh, waves)
    for (let i = 0; i < length; i++) detail.update(still, { uniforms: { time: 0.02 * i } })
    const count = detail.indices.length
    detail.update(still, { uniforms: { time: 0.02 * length }, tolerance: 4 })
    assert.ok(detail.indices.length < 0.6 * count, `${detail.indices.length} of ${count}`)
  }
})
