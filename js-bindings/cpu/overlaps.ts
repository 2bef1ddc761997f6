// Checks whether results and inputs of `evaluate` share memory.
import { Place } from '../options/place.js'
import type { Sink, Stream } from './machine-code.js'

const place = new Place('evaluate')

/** Throws if two results share memory. `names` are the keys of the option `out`. */
export function rejectShared(names: readonly string[], sinks: readonly Sink[], vertices: number) {
  for (let i = 1; i < sinks.length; i++)
    for (let k = 0; k < i; k++) {
      const a = sinks[k]!
      const b = sinks[i]!
      if (a.values.buffer !== b.values.buffer) continue
      if (!overlap(a.values, a.results.length, b.values, b.results.length, vertices)) continue
      throw place.error(
        `out.${names[k]} and out.${names[i]} must not share memory, but ${a.values === b.values ? 'are the same array' : 'are views of the same part of a buffer'}.`,
      )
    }
}

/** Copies inputs that a result would overwrite before they are read: vertices are evaluated in batches. */
export function copyOverwritten(
  inputs: readonly Stream[],
  sinks: readonly Sink[],
  vertices: number,
) {
  for (let i = 0; i < inputs.length; i++) {
    const input = inputs[i]!
    if (!input.isUniform && isOverwritten(input, sinks, vertices))
      input.values = Float32Array.from(input.values)
  }
}

function isOverwritten({ values, size }: Stream, sinks: readonly Sink[], vertices: number) {
  if (!isTyped(values)) return false
  for (let i = 0; i < sinks.length; i++) {
    const { values: to, results } = sinks[i]!
    if (to.buffer !== values.buffer) continue
    // A result that starts no later and has no more bytes per vertex only overwrites vertices that have been read.
    const overwritesOnlyRead =
      to.byteOffset <= values.byteOffset && 4 * results.length <= size * values.BYTES_PER_ELEMENT
    if (!overwritesOnlyRead && overlap(values, size, to, results.length, vertices)) return true
  }
  return false
}

type Typed = Pick<Float32Array, 'buffer' | 'byteOffset' | 'BYTES_PER_ELEMENT'>

const isTyped = (values: ArrayLike<number>): values is ArrayLike<number> & Typed =>
  ArrayBuffer.isView(values)

/** Tests whether two arrays of one buffer, with `sizeOfA` and `sizeOfB` numbers per vertex, overlap. */
const overlap = (a: Typed, sizeOfA: number, b: Typed, sizeOfB: number, vertices: number) =>
  a.byteOffset < endOf(b, sizeOfB, vertices) && b.byteOffset < endOf(a, sizeOfA, vertices)

const endOf = ({ byteOffset, BYTES_PER_ELEMENT }: Typed, size: number, vertices: number) =>
  byteOffset + vertices * size * BYTES_PER_ELEMENT
