// `subdivide`: splits triangles, everywhere or where a warp needs it.
import { snapshotUniforms } from '../core/inputs/declared-uniforms.js'
import { isGeometry, type Geometry } from '../core/inputs/geometry.js'
import type { Uniforms } from '../core/inputs/vertices.js'
import { warpProgram } from '../cpu/warp-program.js'
import { describe } from '../errors/errors.js'
import { anything, positiveNumber, wholeNumber } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { object, type KindsOf } from '../options/schema.js'
import { defaultTriangles, triangleLimit } from '../wasm/mesh-tables.js'
import { evaluateFor, readsVariation, warpKind, type Evaluates } from './evaluates.js'
import { finerGeometry, type Plain } from './geometry.js'
import { withJob, type Job } from './job.js'
import { putMesh, takeMesh, type Mesh, type MeshInput, type MeshOrGeometry } from './mesh-arrays.js'
import { variationOf } from './surface-variation.js'

interface Limit {
  /**
   * The max number of triangles.
   * @default 1048576
   */
  maxTriangles?: number
}

export interface AdaptiveOptions extends Limit {
  /** A result of `compileWarp`. */
  warp: Evaluates
  /** Uniforms of the warp. */
  uniforms?: Uniforms
  /**
   * Max distance between the warped surface and the warped triangles, in units of the model. It is measured at samples, which can miss
   * features narrower than a 200th of the mesh.
   */
  tolerance: number
  /**
   * Max angle, in radians, between the exact warped normals and those interpolated between corners. Infinity ignores normals. 0.17 is
   * 10 degrees.
   * @default 0.17
   */
  angle?: number
}

export interface LevelsOptions extends Limit {
  /** The number of times that each triangle is split into four. */
  levels: number
}

const place = new Place('subdivide')

/**
 * Returns the same surface with more vertices, not warped yet. With `tolerance`, edges are split only where necessary, until the warped
 * triangles are within the tolerance of the warped surface; with `levels`, edges are split everywhere. There are no cracks, and all
 * attributes of new vertices are interpolated. If `maxTriangles` is reached before that, `warnings` says so. A mesh without triangles is
 * returned unchanged. For a `BufferGeometry` of three.js the result is one too, with all its attributes, morph targets and groups, and
 * the warnings in its `userData`. Throws a `WarpError` for wrong options, arrays that do not fit together, and a result that does not
 * fit into the module's 4 GB of memory.
 */
export function subdivide<Original extends Geometry>(
  geometry: Original,
  options: AdaptiveOptions | LevelsOptions,
): Plain<Original>
export function subdivide(mesh: MeshInput, options: AdaptiveOptions | LevelsOptions): Mesh
export function subdivide(mesh: MeshOrGeometry, options: AdaptiveOptions | LevelsOptions): unknown {
  if (typeof options !== 'object' || options === null)
    throw place.expected(
      'options such as { warp, tolerance: 0.01 } or { levels: 2 }',
      describe(options),
    )
  return subdivideBy(
    place,
    mesh,
    'levels' in options ? refineUniformly(options) : refineAdaptively(options),
  )
}

/** Divides the triangles of a job's mesh, and returns warnings. */
type Refine = (job: Job) => string[]

/** Divides a mesh like `subdivide`, with the calls of `refine`; error messages name the function of `place`. */
export function subdivideBy(
  place: Place,
  original: MeshOrGeometry,
  refine: Refine,
): MeshOrGeometry {
  return withJob(place, (job) => {
    putMesh(job, original)
    job.act('addNormals')
    const warnings = refine(job)
    const mesh = warnings.length ? { ...takeMesh(job), warnings } : takeMesh(job)
    if (!isGeometry(original)) return mesh
    const [ends, triangles] = [job.indices('originEnds'), job.indices('originTriangles')]
    return finerGeometry(original, mesh, { ends, triangles })
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
export const defaultGoals = { angle: 0.17, maxTriangles: defaultTriangles }
const adaptiveOptions = object({
  warp: warpKind(),
  uniforms: anything<Uniforms>(),
  tolerance: positiveNumber(),
  angle: positiveNumber({ max: Infinity, default: defaultGoals.angle }),
  maxTriangles,
} satisfies KindsOf<AdaptiveOptions>)

function refineUniformly(options: LevelsOptions): Refine {
  const { levels, maxTriangles } = levelsOptions.read(options, place)
  return (job) => job.refineUniformly(levels, maxTriangles)
}

function refineAdaptively(options: AdaptiveOptions): Refine {
  const { warp, uniforms, ...goals } = adaptiveOptions.read(options, place)
  const values = snapshotUniforms(place, warp[warpProgram]?.declared, uniforms)
  return refineByWarp(place, warp, values, goals)
}

type Goals = Required<Pick<AdaptiveOptions, 'tolerance' | 'angle' | 'maxTriangles'>>

/** Returns a function that divides a mesh where the warp bends it. */
export function refineByWarp(
  place: Place,
  warp: Evaluates,
  uniforms: Uniforms | undefined,
  { tolerance, angle, maxTriangles }: Goals,
): Refine {
  return (job) => {
    const needsVariation = readsVariation(warp)
    if (needsVariation) job.act('addVariation')
    let hasNormals: boolean | undefined
    return job.refine(tolerance, angle, maxTriangles, (vertices) => {
      // Refinement does not use tangents.
      const mesh = {
        ...takeMesh(vertices),
        ...(needsVariation && variationOf(vertices)),
        tangents: undefined,
      }
      const warped = evaluateFor(place, warp, mesh, uniforms)
      hasNormals ??= warped.normals !== undefined
      if (hasNormals !== (warped.normals !== undefined))
        throw place.error(
          "expected the warp's evaluate to return normals either always or never, got normals only sometimes.",
        )
      vertices.setFloats('positions', warped.positions)
      vertices.setFloats('normals', warped.normals ?? [])
    })
  }
}
