// The results of a warp on the CPU: which numbers of the program they are, and the arrays that they go into.
import { WarpError, describe } from '../errors/errors.js'
import { noteChecked } from '../core/inputs/vertices.js'
import type { Sink } from '../wasm/machine-code.js'
import { rejectShared } from './overlaps.js'

/** Flat arrays in the order of the vertices that came. */
export interface WarpedVertices {
  /** Three numbers a vertex. */
  positions: Float32Array
  /** Three numbers a vertex, of length 1, or 0 where the warp collapses the surface; if normals came. */
  normals?: Float32Array
  /**
   * Present if normals and tangents were passed: 4 floats per vertex. The last one is that of the input, or its negative if
   * the warp mirrors all of space.
   */
  tangents?: Float32Array
}

/** The results of the program, by number, as compile-warp.ts asks for them; a warp without normals has only the first three. */
export const numbersOf = {
  positions: [0, 1, 2],
  normals: [3, 4, 5],
  tangents: [6, 7, 8, 9],
  determinant: [10],
}

interface Wanted {
  names: readonly (keyof WarpedVertices)[]
  numbers: readonly number[]
  /** Where `evaluateAt` has them for a moment. */
  point: readonly Sink[]
  /** Sinks that nobody uses, so that `evaluate` need not make any. */
  spare: Sink[] | undefined
}

const wants = (...names: (keyof WarpedVertices)[]): Wanted => ({
  names,
  numbers: names.flatMap((name) => numbersOf[name]),
  point: names.map((name) => {
    const results = numbersOf[name]
    return { values: new Float32Array(results.length), results }
  }),
  spare: undefined,
})

/** Made once, since what is known of a program is found by them. */
export const wanted = {
  place: wants('positions'),
  surface: wants('positions', 'normals'),
  frame: wants('positions', 'normals', 'tangents'),
}

const nothing = new Float32Array()

const sinkOf = (name: keyof WarpedVertices): Sink => ({ values: nothing, results: numbersOf[name] })

/** Takes sinks into the caller's arrays, or new ones. None is left for a getter or a uniform's function that evaluates as well. */
export function takeSinks(
  results: Wanted,
  vertices: number,
  out: Partial<WarpedVertices> | undefined,
): Sink[] {
  const { names } = results
  const sinks = results.spare ?? names.map(sinkOf)
  results.spare = undefined
  for (let i = 0; i < names.length; i++) {
    const sink = sinks[i]!
    const name = names[i]!
    sink.values = arrayFor(name, vertices * sink.results.length, out?.[name])
  }
  if (out) rejectShared(names, sinks, vertices)
  return sinks
}

/** Gives them back without the arrays → these, in the caller's object if it holds just them. */
export function leaveSinks(
  results: Wanted,
  sinks: Sink[],
  out: Partial<WarpedVertices> | undefined,
): WarpedVertices {
  const warped = out && isJust(out, sinks) ? out : named(results.names, sinks)
  for (const sink of sinks) {
    noteChecked(sink.values)
    sink.values = nothing
  }
  results.spare = sinks
  return warped as WarpedVertices
}

/** Whether the caller's object holds these arrays, and no other. */
function isJust(out: Partial<WarpedVertices>, sinks: readonly Sink[]) {
  const all = wanted.frame.names
  for (let i = 0; i < all.length; i++) if (out[all[i]!] !== sinks[i]?.values) return false
  return true
}

const named = (names: readonly string[], sinks: readonly Sink[]) =>
  Object.fromEntries(names.map((name, i) => [name, sinks[i]!.values]))

/** Where so many numbers of a result go: into the caller's array, if one came. */
function arrayFor(name: string, length: number, given: unknown): Float32Array {
  if (given === undefined) return new Float32Array(length)
  if (given instanceof Float32Array && given.length >= length) return given
  const came = given instanceof Float32Array ? `has only ${given.length}` : `is ${describe(given)}`
  throw new WarpError(
    `evaluate: out.${name} must be a Float32Array of at least ${length} numbers, but ${came}.`,
  )
}
