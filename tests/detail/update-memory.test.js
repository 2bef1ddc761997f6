// Tests that an update of a moving mesh creates no garbage in JavaScript.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import * as THREE from 'three'
import { compileWarp } from 'warpjet'
import { createDetail } from 'warpjet/detail'
import { bytesOf } from '../support/allocated-bytes.js'

const along = (height) => (inputs) => {
  const { glsl, position, millis } = inputs
  const moved = position.mult(2).add(glsl.vec3(0, 0, millis.div(1000)))
  return glsl.normalize(position).mult(height(glsl, moved).mult(0.1))
}

const frames = 100

/** Returns the views of a camera around the origin. */
function orbit() {
  const camera = new THREE.PerspectiveCamera(50, 1, 0.1, 10)
  return Array.from({ length: frames }, (_, i) => {
    camera.position.setFromSphericalCoords(2.5, 1.2, i / frames)
    camera.lookAt(0, 0, 0)
    camera.updateMatrixWorld()
    const { projectionMatrix, matrixWorldInverse } = camera
    const { elements } = new THREE.Matrix4().multiplyMatrices(projectionMatrix, matrixWorldInverse)
    return { matrix: elements, width: 640, height: 640 }
  })
}

// A cheap warp is evaluated at all samples, an expensive one at those that the view may show.
const warps = {
  'a cheap warp': along((glsl, p) => p.x().sin()),
  'an expensive warp': along((glsl, p) => glsl.simplex(p)),
}

for (const [name, offset] of Object.entries(warps))
  test(`an update of a moving mesh with ${name} allocates nothing`, async () => {
    const { attributes, index } = new THREE.SphereGeometry(1, 16, 8)
    const mesh = createDetail(
      {
        positions: attributes.position.array,
        normals: attributes.normal.array,
        indices: index.array,
      },
      compileWarp(offset, { normals: false }),
    )
    const views = orbit()
    const options = { uniforms: { millis: 0 }, tolerance: 1 }
    let updates = 0
    let changes = 0
    const update = () => {
      const frame = updates++ % frames
      options.uniforms.millis = 20 * frame
      if (mesh.update(views[frame], options)) changes++
    }
    // Updates often enough that the engine optimizes the code, and that the warp is compiled to machine code.
    for (let i = 0; i < 4000; i++) update()
    changes = 0

    // The engine itself may allocate in a series, while it still compiles, but hardly in two of three.
    const series = []
    for (let i = 0; i < 3; i++) series.push(await bytesOf(update, 500))
    const [, bytes] = series.sort((a, b) => a - b)
    assert.ok(changes > 0, 'the mesh must change')
    assert.ok(bytes < 16, `${bytes} bytes per update`)
  })
