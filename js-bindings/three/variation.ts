// How normals and uvs vary over a geometry, for offsets that depend on them: kept with it, as attributes.
import { BufferAttribute, type BufferGeometry } from 'three'
import { WarpError } from '../errors/errors.js'
import { variationAttribute, variationNames } from '../core/inputs/inputs.js'
import { describeOfThree } from './describe.js'
import { fromBufferGeometry } from './geometry.js'

/**
 * Finds out how normal and uv vary over a geometry, and adds that to it as attributes, so that offsets that depend on them,
 * such as along the normal, turn the light exactly: `await addSurfaceVariation(geometry)`, once, before it is warped. Loads
 * 'warpjet/mesh'. Throws a `WarpError` for what is no geometry of triangles with positions. Gives the geometry.
 */
export async function addSurfaceVariation<Geometry extends BufferGeometry>(
  geometry: Geometry,
): Promise<Geometry> {
  if (!geometry?.isBufferGeometry)
    throw new WarpError(
      `addSurfaceVariation: a BufferGeometry was expected, such as mesh.geometry, but ${describeOfThree(geometry)} came.`,
    )
  const mesh = fromBufferGeometry(geometry)
  const { surfaceVariation } = await import('../mesh/surface-variation.js')
  const variation = surfaceVariation(mesh)
  for (const name of variationNames) {
    const numbers = variation[`${name}s`]
    if (numbers) geometry.setAttribute(variationAttribute(name), new BufferAttribute(numbers, 3))
  }
  return geometry
}
