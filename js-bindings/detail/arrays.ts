// Arrays of numbers.
import type { Vertices } from '../core/inputs/vertices.js'

/** Returns the length of the diagonal of the bounding box. */
export function diagonalOf(positions: ArrayLike<number>): number {
  const min = [Infinity, Infinity, Infinity]
  const max = [-Infinity, -Infinity, -Infinity]
  for (let i = 0; i < positions.length; i++) {
    min[i % 3] = Math.min(min[i % 3]!, positions[i]!)
    max[i % 3] = Math.max(max[i % 3]!, positions[i]!)
  }
  return Math.hypot(...max.map((high, i) => high - min[i]!))
}

/** Copies into `to` if that is an array of the right length, otherwise into a new one. Returns the copy. */
export function copyInto(to: ArrayLike<number> | undefined, from: Float32Array): Float32Array {
  if (!(to instanceof Float32Array) || to.length !== from.length) return from.slice()
  to.set(from)
  return to
}

export const areEqual = (a: readonly number[], b: readonly number[]) =>
  a.length === b.length && a.every((x, i) => x === b[i])

/**
 * Copies the vertices with `count` indices, from `words[at]` on, to the start of arrays that are as long as those of `from`. Creates no
 * garbage.
 */
export function gather(
  from: Vertices,
  words: Uint32Array,
  at: number,
  count: number,
  to: Vertices,
) {
  const vertices = from.positions.length / 3
  for (const key in to) {
    const name = key as 'positions'
    const target = to[name] as Float32Array
    copyVertices(from[name] as Float32Array, words, at, count, target, target.length / vertices)
  }
}

function copyVertices(
  from: Float32Array,
  words: Uint32Array,
  at: number,
  count: number,
  to: Float32Array,
  size: number,
) {
  let next = 0
  for (let i = 0; i < count; i++) {
    const first = size * words[at + i]!
    for (let k = 0; k < size; k++) to[next++] = from[first + k]!
  }
}

/** Copies positions, in order, to the vertices with `count` indices, from `words[at]` on. */
export function scatter(
  from: Float32Array,
  words: Uint32Array,
  at: number,
  count: number,
  to: Float32Array,
) {
  let next = 0
  for (let i = 0; i < count; i++) {
    const first = 3 * words[at + i]!
    for (let k = 0; k < 3; k++) to[first + k] = from[next++]!
  }
}
