// `bakeWarp`: applies a warp to a mesh on the CPU.
import { isGeometry, type Geometry } from '../core/inputs/geometry.js'
import { uniformsOf, type Uniforms, type Vertices } from '../core/inputs/vertices.js'
import type { CpuWarp, EvaluationOptions } from '../cpu/cpu-warp.js'
import type { WarpedVertices } from '../cpu/results.js'
import { warpProgram, type RunningProgram } from '../cpu/warp-program.js'
import { WarpError, describe } from '../errors/errors.js'
import { isList } from '../options/guards.js'
import { kind } from '../options/kinds.js'
import { anyNumber, finiteFloat, firstWrong } from '../options/numbers.js'
import { Place } from '../options/place.js'
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
import { takeVariation, type SurfaceVariation } from './surface-variation.js'

/** The part of `compileWarp`'s result that meshes need. */
export interface Evaluates extends Pick<CpuWarp, 'evaluate'> {
  /** @internal */
  readonly [warpProgram]?: RunningProgram
}

/** The kind of a warp that runs on the CPU; `makers` names the functions that return one, for messages. */
export const warpKind = (makers = 'compileWarp') =>
  kind<Evaluates>(
    `a result of ${makers}`,
    (given) => typeof (given as Evaluates | undefined)?.evaluate === 'function',
  )

const place = new Place('bakeWarp')
const bakedWarp = warpKind()

/** Returns whether the warp needs the gradients of normals and uvs over the mesh. */
export const readsVariation = (warp: Evaluates) => warp[warpProgram]?.varies ?? false

/**
 * Returns the mesh with warped positions, normals and tangents; all else is copied. Missing normals are computed first, and also the
 * gradients of normals and uvs if the warp depends on them. `warp` is a result of `compileWarp`. If it mirrors all of space, `indices`
 * of the result reverse each triangle, so that its outer side stays the front. An empty mesh stays empty; 10 million triangles take
 * some seconds.
 * For a `BufferGeometry` of three.js the result is one too, with all its other attributes and its groups; its morph targets are also
 * warped. Throws a `WarpError` if arrays do not fit together, a uniform is missing, the warp has no finite value at a vertex,
 * or the mesh is too large for the memory of the module (such as 40 million triangles).
 */
export function bakeWarp<Given extends Geometry>(
  geometry: Given,
  warp: Evaluates,
  options?: EvaluationOptions,
): Plain<Given>
export function bakeWarp(mesh: MeshInput, warp: Evaluates, options?: EvaluationOptions): Mesh
export function bakeWarp(
  given: MeshOrGeometry,
  warp: Evaluates,
  options?: EvaluationOptions,
): unknown {
  bakedWarp.read(warp, place.part('the warp'))
  const uniforms = uniformsOf(place, options)
  const bake = (mesh: MeshOrGeometry) => warpMesh(place, mesh, warp, uniforms).warped
  const baked = bake(given)
  if (!isGeometry(given)) return baked
  return movedGeometry(given, baked, isMirroredBy(place, warp, uniforms), bake)
}

/** Returns whether the warp mirrors all of space; false for a warp made by hand, which doesn't have this information. */
const isMirroredBy = (place: Place, warp: Evaluates, uniforms: Uniforms | undefined) =>
  warp[warpProgram]?.isMirrored(place, uniforms) ?? false

/** A copy of a mesh before a warp, with all inputs of the warp, and after it. */
export interface WarpedMesh {
  rest: Mesh & Partial<SurfaceVariation>
  warped: Mesh
}

/** Does the work of `bakeWarp` for a mesh, with messages that name another call. */
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

/** Calls `warp.evaluate`, and makes its messages name the function that the user called. */
export function evaluateFor(
  place: Place,
  warp: Evaluates,
  vertices: Vertices,
  uniforms?: Uniforms,
): WarpedVertices {
  let warped: WarpedVertices
  try {
    warped = warp.evaluate(vertices, { uniforms })
  } catch (error) {
    // The warp may come from another script, which has its own class WarpError.
    const { name, message = '' } = (error ?? {}) as Partial<Error>
    if (name !== 'WarpError') throw error
    throw new WarpError(message.replace(/^evaluate: /, `${place.method}: `))
  }
  if (!warp[warpProgram]) rejectOtherArrays(place.part("the warp's evaluate"), warped, vertices)
  return warped
}

/** Checks the result of a warp that was made by hand. */
function rejectOtherArrays(place: Place, warped: unknown, vertices: Vertices) {
  const count = vertices.positions.length / 3
  const expectToGive = (what: string, got: string) =>
    place.error(`expected ${place.subject} to return ${what}, got ${got}.`)
  if (typeof warped !== 'object' || warped === null)
    throw expectToGive('{ positions, normals }', describe(warped))
  for (const [name, size] of [
    ['positions', 3],
    ['normals', 3],
    ['tangents', 4],
  ] as const) {
    const numbers = (warped as Record<string, unknown>)[name]
    if (numbers === undefined && name !== 'positions') continue
    if (!isList(numbers) || numbers.length !== size * count)
      throw expectToGive(
        `${name} as an array of ${size * count} numbers, ${size} per vertex`,
        describe(numbers),
      )
    const wrong = firstWrong(numbers, anyNumber)
    if (wrong >= 0) throw expectToGive(`a number as ${name}[${wrong}]`, describe(numbers[wrong]))
  }
}

function rejectNonFinite(
  place: Place,
  name: string,
  given: ArrayLike<number>,
  size: number,
  { positions }: Mesh,
) {
  const i = firstWrong(given, finiteFloat)
  if (i < 0) return
  const vertex = Math.floor(i / size)
  const position = [...positions.subarray(3 * vertex, 3 * vertex + 3)].join(', ')
  throw place.error(
    `expected a finite ${name} of vertex ${vertex} at (${position}), got ${given[i]}; check the warp there, for a division by 0 for example.`,
  )
}
