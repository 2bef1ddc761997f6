// `bakeWarp`: applies a warp to a mesh on the CPU.
import { snapshotUniforms } from '../core/inputs/declared-uniforms.js'
import { isGeometry, type Geometry } from '../core/inputs/geometry.js'
import { uniformsOf, type Uniforms } from '../core/inputs/vertices.js'
import type { EvaluationOptions } from '../cpu/cpu-warp.js'
import { warpProgram } from '../cpu/warp-program.js'
import { optional, positiveNumber } from '../options/kinds.js'
import { finiteFloat, firstWrong } from '../options/numbers.js'
import { Place } from '../options/place.js'
import { evaluateFor, readsVariation, warpKind, type Evaluates } from './evaluates.js'
import { movedGeometry, type Plain } from './geometry.js'
import { withJob } from './job.js'
import {
  putMesh,
  reverseTriangles,
  takeMesh,
  type Mesh,
  type MeshInput,
  type MeshOrGeometry,
} from './mesh-arrays.js'
import { defaultGoals, refineByWarp, subdivideBy } from './subdivide.js'
import { takeVariation, type SurfaceVariation } from './surface-variation.js'

export interface BakeOptions extends EvaluationOptions {
  /**
   * If present, the mesh is first divided where the warp bends it, like by `subdivide` with this tolerance: the maximum distance between
   * the warped surface and the baked triangles, in units of the mesh. There is no camera, so it is not in pixels like the option `detail`
   * of `createWarp`. By default, the mesh keeps its own vertices.
   */
  detail?: number | undefined
}

const place = new Place('bakeWarp')
const bakedWarp = warpKind()
const detailKind = optional(positiveNumber())

/**
 * Returns the mesh with warped positions, normals and tangents; all else is copied. Missing normals are computed first, and also the
 * gradients of normals and uvs if the warp depends on them. `warp` is a result of `compileWarp`. If it mirrors all of space, `indices`
 * of the result reverse each triangle, so that its outer side stays the front. An empty mesh stays empty; 10 million triangles take
 * some seconds.
 * For a `BufferGeometry` of three.js the result is one too, with all its other attributes and its groups; its morph targets are also
 * warped. Throws a `WarpError` if arrays do not fit together, a uniform is missing, the warp has no finite value at a vertex,
 * or the mesh is too large for the memory of the module (such as 40 million triangles).
 *
 * @example
 * const baked = bakeWarp(mesh, warp, { uniforms: { millis: 1200 }, detail: 0.01 })
 */
export function bakeWarp<Given extends Geometry>(
  geometry: Given,
  warp: Evaluates,
  options?: BakeOptions,
): Plain<Given>
export function bakeWarp(mesh: MeshInput, warp: Evaluates, options?: BakeOptions): Mesh
export function bakeWarp(given: MeshOrGeometry, warp: Evaluates, options?: BakeOptions): unknown {
  bakedWarp.read(warp, place.part('the warp'))
  const values = uniformsOf(place, options, ['uniforms', 'detail'])
  const tolerance = detailKind.read(options?.detail, place.option('detail'))
  if (tolerance === undefined) return bake(given, warp, values)
  const uniforms = snapshotUniforms(place, warp[warpProgram]?.declared, values)
  const goals = { ...defaultGoals, tolerance }
  return bake(subdivideBy(place, given, refineByWarp(place, warp, uniforms, goals)), warp, uniforms)
}

function bake(given: MeshOrGeometry, warp: Evaluates, uniforms: Uniforms | undefined): unknown {
  const bakeMesh = (mesh: MeshOrGeometry) => warpMesh(place, mesh, warp, uniforms).warped
  const baked = bakeMesh(given)
  if (isGeometry(given))
    return movedGeometry(given, baked, isMirroredBy(place, warp, uniforms), bakeMesh)
  const { warnings } = given as Partial<Mesh>
  return warnings ? { ...baked, warnings } : baked
}

/** Returns whether the warp mirrors all of space; false for a warp made by hand, which doesn't have this information. */
const isMirroredBy = (place: Place, warp: Evaluates, uniforms: Uniforms | undefined) =>
  warp[warpProgram]?.isMirrored(place, uniforms) ?? false

export interface WarpedMesh {
  /** A copy of the mesh before the warp, with all inputs of the warp. */
  rest: Mesh & Partial<SurfaceVariation>
  /** The mesh after the warp. */
  warped: Mesh
}

/** Warps a mesh like `bakeWarp`; messages name the call of `place`. */
export function warpMesh(
  place: Place,
  mesh: MeshOrGeometry,
  warp: Evaluates,
  uniforms: Uniforms | undefined,
): WarpedMesh {
  const { copy, variation } = withJob(place, (job) => {
    putMesh(job, mesh)
    job.act('addNormals')
    return { copy: takeMesh(job), variation: readsVariation(warp) ? takeVariation(job) : {} }
  })
  const vertices = { ...copy, ...variation }
  const { positions, normals, tangents } = evaluateFor(place, warp, vertices, uniforms)
  if (!normals)
    throw place.error(
      'the warp was compiled with "normals: false"; compile it without this option.',
    )
  rejectNonFinite(place, 'position', positions, 3, copy)
  rejectNonFinite(place, 'normal', normals, 3, copy)
  if (tangents) rejectNonFinite(place, 'tangent', tangents, 4, copy)
  const baked = { ...copy, positions, normals, ...(tangents && { tangents }) }
  const isMirrored = isMirroredBy(place, warp, uniforms)
  return { rest: vertices, warped: isMirrored ? reverseTriangles(baked) : baked }
}

function rejectNonFinite(
  place: Place,
  name: string,
  numbers: ArrayLike<number>,
  size: number,
  { positions }: Mesh,
) {
  const i = firstWrong(numbers, finiteFloat)
  if (i < 0) return
  const vertex = Math.floor(i / size)
  const position = [...positions.subarray(3 * vertex, 3 * vertex + 3)].join(', ')
  throw place.error(
    `expected a finite ${name} of vertex ${vertex} at (${position}), got ${numbers[i]}; check the warp there, for a division by 0 for example.`,
  )
}
