// Meshes, warps and checks that the tests of 'warpjet/mesh' share.
import assert from 'node:assert/strict'
import { afterEach } from 'node:test'
import { compileWarp } from 'warpjet'
import { exportGLB } from 'warpjet/mesh'
import { meshMemoryInUse } from '../../dist/memory.js'
import { readGlb } from './glb.js'
import { triangle } from './meshes.js'
import { png } from './png.js'

export const picture = png(2, 2, (x, y) => [255 * x, 255 * y, 0])
export const material = {
  baseColor: [1, 0.5, 0.25, 0.75],
  baseColorTexture: { bytes: picture, mimeType: 'image/png' },
}

export const twist = compileWarp(({ glsl, position }) => {
  const angle = position.y().mult(2)
  return glsl.rotateY(angle).mult(position).sub(position)
})
export const rise = compileWarp(({ glsl, millis }) => glsl.vec3(0, millis, 0))

/** Asserts after each test that the next call works, and that the wasm module has freed its memory. */
export function checkMemoryAfterEach() {
  const memory = meshMemoryInUse()
  afterEach(() => {
    assert.equal(exportGLB(triangle()).length % 4, 0)
    assert.equal(meshMemoryInUse(), memory)
  })
}

/** Returns the mesh as a .gltf file whose buffer has this URI, and the content of the buffer. */
export function withBuffer(mesh, uri) {
  const { json, chunks } = readGlb(exportGLB(mesh))
  json.buffers[0].uri = uri
  return { text: new TextEncoder().encode(JSON.stringify(json)), buffer: chunks[1].bytes }
}
