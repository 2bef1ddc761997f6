// Computes how normals and uvs vary over a geometry, and stores the result in attributes.
import { InterleavedBuffer, InterleavedBufferAttribute, type BufferGeometry } from 'three'
import { variationAttribute, variationNames } from '../compile/hosts.js'
import { WarpError } from '../errors/errors.js'
import type { surfaceVariation } from '../mesh/surface-variation.js'
import { describeOfThree } from './describe.js'
import { fromBufferGeometry } from './geometry.js'

/**
 * Computes how normal and uv vary over a geometry and adds the result as attributes, so that offsets that depend on them,
 * such as one along the normal, get exact normals: `await addSurfaceVariation(geometry)`, once, before the geometry is warped. Loads
 * 'warpjet/mesh'. Returns the geometry. Throws a `WarpError` unless the geometry consists of triangles with positions.
 */
export async function addSurfaceVariation<Geometry extends BufferGeometry>(
  geometry: Geometry,
): Promise<Geometry> {
  if (!geometry?.isBufferGeometry)
    throw new WarpError(
      `addSurfaceVariation: expected a BufferGeometry, such as mesh.geometry, got ${describeOfThree(geometry)}.`,
    )
  const { surfaceVariation } = await import('../mesh/surface-variation.js')
  addVariation(geometry, surfaceVariation)
  return geometry
}

/** Adds the attributes. `find` is `surfaceVariation` of 'warpjet/mesh', which the caller loads. */
export function addVariation(geometry: BufferGeometry, find: typeof surfaceVariation) {
  const variation = find(fromBufferGeometry(geometry))
  const found = variationNames.filter((name) => variation[`${name}s`])
  const buffer = interleave(found.map((name) => variation[`${name}s`]!))
  found.forEach((name, i) =>
    geometry.setAttribute(
      variationAttribute(name),
      new InterleavedBufferAttribute(buffer, 3, 3 * i),
    ),
  )
}

/** Interleaves lists of 3D vectors in one buffer, since WebGPU allows only 8 vertex buffers, and a geometry may already have 6. */
function interleave(lists: readonly Float32Array[]): InterleavedBuffer {
  const stride = 3 * lists.length
  const count = lists[0] ? lists[0].length / 3 : 0
  const numbers = new Float32Array(stride * count)
  lists.forEach((list, column) => {
    for (let i = 0; i < count; i++)
      numbers.set(list.subarray(3 * i, 3 * i + 3), stride * i + 3 * column)
  })
  return new InterleavedBuffer(numbers, stride)
}
