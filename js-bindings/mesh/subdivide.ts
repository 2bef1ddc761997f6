// `subdivide`: more triangles, where a warp needs them.
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { describe } from '../errors/errors.js'
import { anything, positiveNumber, wholeNumber } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { type KindsOf, object } from '../options/schema.js'
import { snapshotUniforms } from '../core/inputs/declared-uniforms.js'
import type { Uniforms } from '../core/inputs/vertices.js'
import { warpProgram } from '../cpu/warp-program.js'
import { type Evaluates, asksForVariation, evaluateFor, warpKind } from './bake.js'
import { type Geometry, isGeometry } from '../core/inputs/geometry.js'
import { type Plain, finerGeometry } from './geometry.js'
import { type Mesh, type MeshInput, type MeshOrGeometry, putMesh, takeMesh } from './mesh-arrays.js'
import { type Job, withJob } from './job.js'
import { defaultTriangles, triangleLimit } from '../wasm/mesh-tables.js'
import { variationOf } from './surface-variation.js'

interface Limit {
  /** Never more than so many; 1,048,576 unless given. */
  maxTriangles?: number
}

export interface AdaptiveOptions extends Limit {
  /** What `compileWarp` returns. */
  warp: Evaluates
  /** Of the warp. */
  uniforms?: Uniforms
  /** How far the warped surface may leave its triangles, in units of the model. It is looked at in samples, so that what is
   * narrower than a 200th of the mesh can be missed. */
  tolerance: number
  /** How far, in radians, warped normals may turn away from those between corners: 0.17 (10 degrees) unless given.
   * Infinity leaves normals out. */
  angle?: number
}

export interface LevelsOptions extends Limit {
  /** How often each triangle becomes four. */
  levels: number
}

const place = new Place('subdivide')

/**
 * The same surface with more vertices, not warped yet. Edges are split until the warped triangles are as near to the
 * warped surface as `tolerance` says, only where that is needed; or, with `levels`, everywhere. No cracks come up, and
 * new vertices lie between the old ones in every attribute. If `maxTriangles` ends it before, `warnings` says so. A mesh
 * without triangles comes back as it is. A `BufferGeometry` of three.js comes back as one, with all its attributes, morph
 * targets and groups, and the warnings in its `userData`. Throws a `WarpError` for wrong options, arrays that do not fit together, and a
 * result that does not fit into the 4 GB of the module.
 */
export function subdivide<Given extends Geometry>(
  geometry: Given,
  options: AdaptiveOptions | LevelsOptions,
): Plain<Given>
export function subdivide(mesh: MeshInput, options: AdaptiveOptions | LevelsOptions): Mesh
export function subdivide(
  given: MeshOrGeometry,
  options: AdaptiveOptions | LevelsOptions,
): unknown {
  if (typeof options !== 'object' || options === null)
    throw place.expected(
      'options such as { warp, tolerance: 0.01 } or { levels: 2 }',
      describe(options),
    )
  const refine = 'levels' in options ? uniformly(options) : adaptively(options)
  return withJob(place.method, (job) => {
    putMesh(job, given)
    job.act('addNormals')
    const warnings = refine(job)
    const mesh = warnings.length ? { ...takeMesh(job), warnings } : takeMesh(job)
    if (!isGeometry(given)) return mesh
    const [ends, triangles] = [job.indices('ends'), job.indices('triangles')]
    return finerGeometry(given, mesh, { ends, triangles })
  })
}

const maxTriangles = wholeNumber({
  min: 1,
  max: triangleLimit,
  maxName: `2^${Math.log2(triangleLimit)}`,
  default: defaultTriangles,
})
const levelsOptions = object({
  levels: wholeNumber({ max: 15 }),
  maxTriangles,
} satisfies KindsOf<LevelsOptions>)
const adaptiveOptions = object({
  warp: warpKind(),
  uniforms: anything<Uniforms>(),
  tolerance: positiveNumber(),
  angle: positiveNumber({ max: Infinity, default: 0.17 }),
  maxTriangles,
} satisfies KindsOf<AdaptiveOptions>)

function uniformly(options: LevelsOptions) {
  const { levels, maxTriangles } = levelsOptions.read(options, place)
  return (job: Job) => job.refineUniformly(levels, maxTriangles)
}

function adaptively(options: AdaptiveOptions) {
  const { warp, tolerance, angle, maxTriangles, ...given } = adaptiveOptions.read(options, place)
  const { declared } = (warp as Partial<CpuWarp>)[warpProgram] ?? {}
  const uniforms = snapshotUniforms(place, declared, given.uniforms)
  return (job: Job) => {
    const varies = asksForVariation(warp)
    if (varies) job.act('addVariation')
    let givesNormals: boolean | undefined
    return job.refine(tolerance, angle, maxTriangles, (vertices) => {
      // Tangents are not looked at, so none need be turned.
      const mesh = {
        ...takeMesh(vertices),
        ...(varies && variationOf(vertices)),
        tangents: undefined,
      }
      const warped = evaluateFor(place, warp, mesh, uniforms)
      givesNormals ??= warped.normals !== undefined
      if (givesNormals !== (warped.normals !== undefined))
        throw place.error(
          "the warp's evaluate must give normals each time that it is called or never, but gave them only sometimes.",
        )
      vertices.setFloats('positions', warped.positions)
      vertices.setFloats('normals', warped.normals ?? [])
    })
  }
}
