// Computes gradients of normal and uv on a p5.Geometry and stores them as vertex properties, which p5 2.x passes to shaders as
// attributes. This code is part of the mesh module rather than the addon, since only the mesh module needs it.
import { arrayNames, variationAttribute, variationNames } from '../../compile/hosts.js'
import { describe } from '../../errors/errors.js'
import { findVariation, type SurfaceVariation } from '../../mesh/surface-variation.js'
import { Place } from '../../options/place.js'

/** The members of a p5.Geometry that we use. */
interface Geometry {
  vertices: { x: number; y: number; z: number }[]
  vertexNormals: { x: number; y: number; z: number }[]
  uvs: number[]
  faces: number[][]
  dirtyFlags: Record<string, boolean>
  userVertexProperties: Record<string, { resetSrcArray(): void } | undefined>
  vertexProperty?(name: string, value: number[]): void
}

const place = new Place('addSurfaceVariation')

/**
 * Computes and stores the gradients; replaces earlier ones. For the p5 addon's `addSurfaceVariation`, not for users.
 * @internal
 */
export function varyGeometry(geometry: unknown) {
  const shape = geometry as Geometry | undefined
  if (!Array.isArray(shape?.vertices))
    throw place.expected(
      'a p5.Geometry, such as buildGeometry(() => sphere(100)),',
      describe(geometry),
    )
  if (!shape.vertexProperty) throw place.error('this p5 has no vertex properties; use p5 2.')
  const { vertices, vertexNormals, uvs, faces } = shape
  const flat = (vectors: typeof vertices) => vectors.flatMap(({ x, y, z }) => [x, y, z])
  const isComplete = (list: unknown[], size: number) => list.length === size * vertices.length
  const variation = findVariation(place, {
    positions: flat(vertices),
    normals: isComplete(vertexNormals, 1) ? flat(vertexNormals) : undefined,
    uvs: isComplete(uvs, 2) ? uvs : undefined,
    indices: faces.length ? faces.flat() : undefined,
  })
  for (const name of variationNames) {
    const attribute = variationAttribute(name)
    const numbers = variation[arrayNames[name] as keyof SurfaceVariation]
    shape.userVertexProperties[attribute]?.resetSrcArray()
    for (let i = 0; i < vertices.length; i++)
      shape.vertexProperty(attribute, numbers ? [...numbers.subarray(3 * i, 3 * i + 3)] : [0, 0, 0])
    // Makes p5 upload the attribute again if it has drawn the shape before.
    shape.dirtyFlags[`${attribute}Src`] = true
  }
}
