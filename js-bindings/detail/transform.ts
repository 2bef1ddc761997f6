// Transforms samples into the space of the offset.
import type { Vertices } from '../core/inputs/vertices.js'

/** The arrays that a transform writes. They are as long as those of the samples. */
export interface InSpace {
  readonly positions: Float32Array
  readonly normals: Float32Array
}

/** Returns arrays for samples; `before` if they have the right lengths. */
export function arraysInSpace({ positions, normals }: Vertices, before?: InSpace): InSpace {
  const lengths = { positions: positions.length, normals: normals?.length ?? 0 }
  return before?.positions.length === lengths.positions && before.normals.length === lengths.normals
    ? before
    : {
        positions: new Float32Array(lengths.positions),
        normals: new Float32Array(lengths.normals),
      }
}

interface Transform {
  /** Transforms positions: 16 numbers by columns. */
  readonly matrix: ArrayLike<number>
  /** Transforms normals: 9 numbers by columns. */
  readonly normalMatrix: ArrayLike<number>
  /** `true` if normals have length 1 in the space of the offset. */
  readonly hasUnitNormals: boolean
}

/** Writes transformed positions and normals into `to`. Returns all arrays, in the space of the offset. */
export function transformSamples(samples: Vertices, to: InSpace, transform: Transform): Vertices {
  const { matrix, normalMatrix, hasUnitNormals } = transform
  multiply(to.positions, samples.positions, matrix, 4)
  if (!samples.normals) return { ...samples, positions: to.positions }
  multiply(to.normals, samples.normals, normalMatrix, 3)
  if (hasUnitNormals) normalize(to.normals)
  return { ...samples, positions: to.positions, normals: to.normals }
}

/** Multiplies vectors of 3 numbers by a matrix, whose columns have `rows` numbers, and adds its fourth column if there is one. */
function multiply(to: Float32Array, vectors: ArrayLike<number>, m: ArrayLike<number>, rows: 3 | 4) {
  for (let i = 0; i < to.length; i += 3)
    for (let k = 0; k < 3; k++)
      to[i + k] =
        m[k]! * vectors[i]! +
        m[rows + k]! * vectors[i + 1]! +
        m[2 * rows + k]! * vectors[i + 2]! +
        (rows === 4 ? m[12 + k]! : 0)
}

/** Zero vectors stay as they are. */
function normalize(vectors: Float32Array) {
  for (let i = 0; i < vectors.length; i += 3) {
    const square = vectors[i]! ** 2 + vectors[i + 1]! ** 2 + vectors[i + 2]! ** 2
    const length = Math.sqrt(square) || 1
    for (let k = 0; k < 3; k++) vectors[i + k]! /= length
  }
}
