// For the p5 addon: `subdivide` of a p5.Geometry. It stands here, and not in the addon, because it is of use only with this module.
import { WarpError, describe } from '../../errors/errors.js'
import { checkWarp } from '../../mesh/bake.js'
import type { Makers, Vector, WarpModel } from './model.js'
import { type AdaptiveOptions, type LevelsOptions, subdivide } from '../../mesh/subdivide.js'

/**
 * Fills the model `dense` with the surface of `shape` and more vertices: each triangle becomes four, so many times, or what `subdivide`
 * takes. For the p5 addon's `subdivide`, not for users. Throws a `WarpError`.
 * @internal
 */
export function subdivideP5Model(
  dense: WarpModel,
  { Vector }: Makers,
  shape: unknown,
  options: number | AdaptiveOptions | LevelsOptions,
) {
  const given = shape as WarpModel | undefined
  if (!Array.isArray(given?.vertices) || !given.faces.length)
    throw new WarpError(
      `subdivide: a p5.Geometry with triangles was expected, such as buildGeometry(() => box(100)), but ${describe(shape)} came.`,
    )
  if (typeof options === 'object' && 'warp' in options)
    checkWarp('subdivide', options.warp, 'createWarp or compileWarp')
  const { vertices, vertexNormals, vertexColors, uvs, faces } = given
  const flat = (vectors: Vector[]) => vectors.flatMap(({ x, y, z }) => [x, y, z])
  const ifWhole = (list: number[], size: number) =>
    list.length === size * vertices.length ? list : undefined
  const mesh = subdivide(
    {
      positions: flat(vertices),
      normals: ifWhole(flat(vertexNormals), 3),
      uvs: ifWhole(uvs.flat(), 2),
      colors: ifWhole(vertexColors, 4),
      indices: faces.flat(),
    },
    typeof options === 'number' ? { levels: options } : options,
  )
  const count = mesh.positions.length / 3
  const vectors = (numbers: Float32Array) =>
    Array.from(
      { length: count },
      (_, i) => new Vector(numbers[3 * i]!, numbers[3 * i + 1]!, numbers[3 * i + 2]!),
    )
  dense.vertices = vectors(mesh.positions)
  dense.vertexNormals = vectors(mesh.normals)
  dense.uvs = [...(mesh.uvs ?? new Float32Array(2 * count))]
  dense.vertexColors = [...(mesh.colors ?? [])]
  dense.faces = Array.from({ length: mesh.indices!.length / 3 }, (_, i) => [
    ...mesh.indices!.subarray(3 * i, 3 * i + 3),
  ])
  dense.warnings.push(...(mesh.warnings ?? []))
}
