// Subdivides a p5.Geometry. This code is part of the mesh module rather than the addon, since only the mesh module needs it.
import { describe } from '../../errors/errors.js'
import { warpKind } from '../../mesh/evaluates.js'
import { subdivide, type AdaptiveOptions, type LevelsOptions } from '../../mesh/subdivide.js'
import { Place } from '../../options/place.js'
import type { P5Constructors, Vector, WarpModel } from './model.js'

const place = new Place('subdivide')
const warpOption = warpKind('createWarp or compileWarp')

/**
 * Fills the model `dense` with a subdivision of `shape`: a number n splits each triangle into four, n times; other options are those of
 * `subdivide`. For the p5 addon's `subdivide`, not for users. Throws a `WarpError` for a shape without triangles, and for wrong options.
 * @internal
 */
export function subdivideP5Model(
  dense: WarpModel,
  { Vector }: P5Constructors,
  shape: unknown,
  options: number | AdaptiveOptions | LevelsOptions,
) {
  const geometry = shape as WarpModel | undefined
  if (!Array.isArray(geometry?.vertices) || !geometry.faces.length)
    throw place.expected(
      'a p5.Geometry with triangles, such as buildGeometry(() => box(100)),',
      describe(shape),
    )
  if (typeof options === 'object' && 'warp' in options)
    warpOption.read(options.warp, place.option('warp'))
  const { vertices, vertexNormals, vertexColors, uvs, faces } = geometry
  const flat = (vectors: Vector[]) => vectors.flatMap(({ x, y, z }) => [x, y, z])
  const ifComplete = (list: number[], size: number) =>
    list.length === size * vertices.length ? list : undefined
  const mesh = subdivide(
    {
      positions: flat(vertices),
      normals: ifComplete(flat(vertexNormals), 3),
      uvs: ifComplete(uvs.flat(), 2),
      colors: ifComplete(vertexColors, 4),
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
