// For the p5 addon: how a p5.Geometry varies, kept with it as properties of its vertices, which p5 2.x hands to shaders as
// attributes. It stands here, and not in the addon, because it is of use only with this module.
import { WarpError, describe } from '../../errors/errors.js'
import { variationAttribute, variationNames } from '../../core/inputs/inputs.js'
import { arrayNames } from '../../core/inputs/vertices.js'
import { type SurfaceVariation, findVariation } from '../../mesh/surface-variation.js'

/** What is used of a p5.Geometry. */
interface Geometry {
  vertices: { x: number; y: number; z: number }[]
  vertexNormals: { x: number; y: number; z: number }[]
  uvs: number[]
  faces: number[][]
  dirtyFlags: Record<string, boolean>
  userVertexProperties: Record<string, { resetSrcArray(): void } | undefined>
  vertexProperty?(name: string, value: number[]): void
}

/**
 * In place of what was there before. For the p5 addon's `addSurfaceVariation`, not for users.
 * @internal
 */
export function varyGeometry(geometry: unknown) {
  const method = 'addSurfaceVariation'
  const shape = geometry as Geometry | undefined
  if (!Array.isArray(shape?.vertices))
    throw new WarpError(
      `${method}: a p5.Geometry was expected, such as buildGeometry(() => sphere(100)), but ${describe(geometry)} came.`,
    )
  if (!shape.vertexProperty)
    throw new WarpError(`${method}: this p5 keeps no properties of vertices; use p5 2.`)
  const { vertices, vertexNormals, uvs, faces } = shape
  const flat = (vectors: typeof vertices) => vectors.flatMap(({ x, y, z }) => [x, y, z])
  const isWhole = (list: unknown[], size: number) => list.length === size * vertices.length
  const found = findVariation(method, {
    positions: flat(vertices),
    normals: isWhole(vertexNormals, 1) ? flat(vertexNormals) : undefined,
    uvs: isWhole(uvs, 2) ? uvs : undefined,
    indices: faces.length ? faces.flat() : undefined,
  })
  for (const name of variationNames) {
    const attribute = variationAttribute(name)
    const numbers = found[arrayNames[name] as keyof SurfaceVariation]
    shape.userVertexProperties[attribute]?.resetSrcArray()
    for (let i = 0; i < vertices.length; i++)
      shape.vertexProperty(attribute, numbers ? [...numbers.subarray(3 * i, 3 * i + 3)] : [0, 0, 0])
    // p5 has it on the GPU, if it drew the shape before.
    shape.dirtyFlags[`${attribute}Src`] = true
  }
}
