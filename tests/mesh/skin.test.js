// Loads a skinned model that gltf-validator accepts, in the pose of its joints, and compares it with numbers computed by hand.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import validator from 'gltf-validator'
import { loadMesh } from 'warpjet/mesh'
import { writeGlb } from '../support/glb.js'

/**
 * Makes a model with two joints. Joint 1 is at x = 1, where it was bound. Joint 2, bound 2 above joint 1, is rotated by 90°: x to y, y to
 * -x.
 */
function skinnedModel() {
  const translation = (x, y) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 0, 1]
  const arrays = [
    { type: 'VEC3', numbers: Float32Array.of(0, 0, 0, 2, 2, 0, 2, 2, 3) },
    { type: 'VEC4', numbers: Uint8Array.of(0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0) },
    { type: 'VEC4', numbers: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0) },
    { type: 'MAT4', numbers: Float32Array.of(...translation(-1, 0), ...translation(-1, -2)) },
  ]
  const bytes = Buffer.concat(arrays.map(({ numbers }) => Buffer.from(numbers.buffer)))
  let byteOffset = 0
  const bufferViews = arrays.map(({ numbers: { byteLength } }) => {
    const view = { buffer: 0, byteOffset, byteLength }
    byteOffset += byteLength
    return view
  })
  const accessors = arrays.map(({ type, numbers }, bufferView) => ({
    bufferView,
    componentType: numbers instanceof Uint8Array ? 5121 : 5126,
    count: numbers.length / { VEC3: 3, VEC4: 4, MAT4: 16 }[type],
    type,
  }))
  Object.assign(accessors[0], { min: [0, 0, 0], max: [2, 2, 3] })
  const attributes = { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2 }
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0, 1] }],
    nodes: [
      { mesh: 0, skin: 0 },
      { translation: [1, 0, 0], children: [2] },
      { translation: [0, 2, 0], rotation: [0, 0, Math.SQRT1_2, Math.SQRT1_2] },
    ],
    skins: [{ joints: [1, 2], inverseBindMatrices: 3 }],
    meshes: [{ primitives: [{ attributes }] }],
    buffers: [{ byteLength: bytes.length }],
    bufferViews,
    accessors,
  }
  return writeGlb(json, bytes)
}

test('a skinned model is loaded in the pose of its joints', async () => {
  const bytes = skinnedModel()
  const { issues } = await validator.validateBytes(bytes)
  assert.deepEqual([issues.numErrors, issues.numWarnings], [0, 0], JSON.stringify(issues.messages))
  const { positions, warnings } = await loadMesh(bytes)
  assert.equal(warnings, undefined)
  // The last vertex follows both joints: half of (2, 2, 3), its original position, and half of (1, 3, 3).
  const expected = [0, 0, 0, 1, 3, 0, 1.5, 2.5, 3]
  positions.forEach((x, i) => assert.ok(Math.abs(x - expected[i]) < 1e-6, `${i}: ${x}`))
})
