// Arrays of numbers.

/** The length of the diagonal of a box around positions. */
export function diagonalOf(positions: ArrayLike<number>): number {
  const min = [Infinity, Infinity, Infinity]
  const max = [-Infinity, -Infinity, -Infinity]
  for (let i = 0; i < positions.length; i++) {
    min[i % 3] = Math.min(min[i % 3]!, positions[i]!)
    max[i % 3] = Math.max(max[i % 3]!, positions[i]!)
  }
  return Math.hypot(...max.map((high, i) => high - min[i]!))
}

/** Copies into the array if it has the right length, or else into a new one. */
export function copyInto(to: ArrayLike<number> | undefined, from: Float32Array): Float32Array {
  if (!(to instanceof Float32Array) || to.length !== from.length) return from.slice()
  to.set(from)
  return to
}

export const areEqual = (a: readonly number[], b: readonly number[]) =>
  a.length === b.length && a.every((x, i) => x === b[i])
