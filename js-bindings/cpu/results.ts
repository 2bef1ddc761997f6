// The results of a warp on the CPU: their numbers in the program, and the arrays that receive them.
import { markChecked } from '../core/inputs/vertices.js'
import { ResultSet } from '../core/module/result-set.js'
import { describe } from '../errors/errors.js'
import { Place } from '../options/place.js'
import type { Sink } from './machine-code.js'
import { rejectShared } from './overlaps.js'
import { Pool } from './pool.js'

/** Flat arrays, in the order of the vertices that were passed. */
export interface WarpedVertices {
  /** 3 floats per vertex. */
  positions: Float32Array
  /** Present if normals were passed: 3 floats per vertex. The length is 1, or 0 where the warp collapses the surface. */
  normals?: Float32Array
  /**
   * Present if normals and tangents were passed: 4 floats per vertex. The fourth is that of the input tangent, or its negative if
   * the warp mirrors all of space.
   */
  tangents?: Float32Array
}

/** Numbers of the results in the program, as host-warp.ts orders them. A warp without normals has only the first three. */
export const resultNumbers = {
  positions: [0, 1, 2],
  normals: [3, 4, 5],
  tangents: [6, 7, 8, 9],
  determinant: [10],
}

/** Results that `evaluate` computes together, with the sinks that receive them. */
export class VertexResults extends ResultSet {
  /** The sinks of `evaluateAt`, of one vertex. */
  readonly point: readonly Sink[]
  /** The sinks of `evaluate`, which refer to the caller's arrays during a call. */
  readonly sinks: Pool<Sink[]>

  constructor(readonly names: readonly (keyof WarpedVertices)[]) {
    super(names.flatMap((name) => resultNumbers[name]))
    this.point = names.map((name) => sinkOf(name, new Float32Array(resultNumbers[name].length)))
    this.sinks = new Pool(() => names.map((name) => sinkOf(name, noValues)))
  }
}

const noValues = new Float32Array()

const sinkOf = (name: keyof WarpedVertices, values: Float32Array): Sink => ({
  values,
  results: resultNumbers[name],
})

export const vertexResults = {
  position: new VertexResults(['positions']),
  surface: new VertexResults(['positions', 'normals']),
  frame: new VertexResults(['positions', 'normals', 'tangents']),
}

/** The result of `bounds`. */
export const positionsAlone = new ResultSet(resultNumbers.positions)
/** The result of `foldover`. */
export const determinantAlone = new ResultSet(resultNumbers.determinant)

/**
 * Takes sinks from the pool, for the caller's arrays or for new ones. If a getter of `out` or a uniform's function calls `evaluate`, that
 * call gets other sinks.
 */
export function takeSinks(
  results: VertexResults,
  vertices: number,
  out: Partial<WarpedVertices> | undefined,
): Sink[] {
  const { names } = results
  const sinks = results.sinks.take()
  for (let i = 0; i < names.length; i++) {
    const sink = sinks[i]!
    const name = names[i]!
    sink.values = arrayFor(name, vertices * sink.results.length, out?.[name])
  }
  if (out) rejectShared(names, sinks, vertices)
  return sinks
}

/** Gives sinks back to the pool, and returns their arrays, in the object `out` if it holds exactly these. */
export function releaseSinks(
  results: VertexResults,
  sinks: Sink[],
  out: Partial<WarpedVertices> | undefined,
): WarpedVertices {
  const warped = out && hasExactly(out, sinks) ? out : arraysByName(results.names, sinks)
  for (const sink of sinks) {
    markChecked(sink.values)
    sink.values = noValues
  }
  results.sinks.giveBack(sinks)
  return warped as WarpedVertices
}

/** Tests whether the caller's object holds these arrays and no others. */
function hasExactly(out: Partial<WarpedVertices>, sinks: readonly Sink[]) {
  const all = vertexResults.frame.names
  for (let i = 0; i < all.length; i++) if (out[all[i]!] !== sinks[i]?.values) return false
  return true
}

const arraysByName = (names: readonly string[], sinks: readonly Sink[]) =>
  Object.fromEntries(names.map((name, i) => [name, sinks[i]!.values]))

/** Returns the caller's array for a result, or a new one. */
function arrayFor(name: string, length: number, array: unknown): Float32Array {
  if (array === undefined) return new Float32Array(length)
  if (array instanceof Float32Array && array.length >= length) return array
  throw new Place('evaluate', `out.${name}`).expected(
    `a Float32Array of at least ${length} numbers`,
    array instanceof Float32Array ? `one of ${array.length}` : describe(array),
  )
}
