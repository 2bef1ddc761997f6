// Coarse meshes, whose surface between vertices is known, and the distance of a divided mesh from its warped surface.
import assert from 'node:assert/strict'
import * as THREE from 'three'
import { quantile, randomScreenErrors } from './screen-error.js'
import { randomNumbers } from './three-meshes.js'

export const arraysOf = ({ attributes, index }) => ({
  positions: attributes.position.array,
  indices: index.array,
})
/** The meshes, with the height of their surface at x and y. */
export const coarseMeshes = {
  'a box of 12 triangles': { ...arraysOf(new THREE.BoxGeometry(2, 2, 2)), z: () => 1 },
  'a plane of two triangles': { ...arraysOf(new THREE.PlaneGeometry(2, 2)), z: () => 0 },
  // The default of p5.
  'a sphere of 24 × 16 parts': {
    ...arraysOf(new THREE.SphereGeometry(1, 24, 16)),
    z: (x, y) => Math.sqrt(1 - x * x - y * y),
  },
}

/** Moves points along z. */
export const raise = (glsl, height) => glsl.vec3(0, 0, height.mult(0.3))

/** Returns the view of a camera at a place, which looks at a target. */
export function viewFrom(place, target = [0, 0, 0]) {
  const camera = new THREE.PerspectiveCamera(60, 1, 0.1, 30)
  camera.position.set(...place)
  camera.lookAt(...target)
  camera.updateMatrixWorld()
  const { projectionMatrix, matrixWorldInverse } = camera
  const { elements } = projectionMatrix.clone().multiply(matrixWorldInverse)
  return { matrix: elements, width: 600, height: 600 }
}
export const views = [viewFrom([2, 1, 4]), viewFrom([3, -2, 2]), viewFrom([-1, 3, 2.5])]

const copyOf = ({ positions, indices }) => ({
  positions: positions.slice(),
  indices: indices.slice(),
})

/**
 * Expects 99.9% of a mesh to be within a pixel of the surface that `raise` makes of it: near the place of interest, and everywhere.
 * `height` and `isNear` are functions of a point and of the uniform `shift`.
 */
export function expectClose(divided, { height, isNear }, view, shift = 0) {
  const mesh = copyOf(divided)
  const warpPoint = (p) => [p[0], p[1], p[2] + 0.3 * height(p, shift)]
  const random = randomNumbers(11)
  const measure = (count, isMeasured) =>
    randomScreenErrors(mesh, warpPoint, view, random, count, isMeasured)
  const near = measure(600_000, (p) => isNear(p, shift))
  assert.ok(near.length > 400, `${near.length} points`)
  for (const errors of [near, measure(20_000, () => true)]) {
    const error = quantile(errors, 0.999)
    assert.ok(error <= 1, `${error.toFixed(2)} pixels with ${mesh.indices.length / 3} triangles`)
  }
}
