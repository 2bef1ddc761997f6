// The tangent frames of a mesh, and normals in them as colours.
import type { Surface } from './surface.js'

/** The min z of a normal in its map: glTF stores no others, which point to the other side of the surface. */
const minZ = 1 / 255

/**
 * The frames as programs interpolate them over triangles: tangent, bitangent and normal are interpolated each for itself, with the
 * bitangent computed at the vertices, and normalized at the pixel. three.js and Khronos' glTF viewer do so.
 */
export class TangentFrames {
  private readonly axes: readonly Float32Array[]
  /** Tangent, bitangent and normal at a point. */
  private readonly frame = new Float64Array(9)

  constructor({ normals, tangents }: Surface['warped']) {
    const directions = new Float32Array(normals.length)
    const bitangents = new Float32Array(normals.length)
    for (let i = 0, t = 0; i < normals.length; i += 3, t += 4) {
      const [nx, ny, nz] = [normals[i]!, normals[i + 1]!, normals[i + 2]!]
      const [tx, ty, tz] = [tangents[t]!, tangents[t + 1]!, tangents[t + 2]!]
      const sign = tangents[t + 3]!
      directions.set([tx, ty, tz], i)
      bitangents[i] = sign * (ny * tz - nz * ty)
      bitangents[i + 1] = sign * (nz * tx - nx * tz)
      bitangents[i + 2] = sign * (nx * ty - ny * tx)
    }
    normalizeVectors(bitangents)
    this.axes = [directions, bitangents, normals]
  }

  /** Interpolates the frame between the three vertices at `vertices[first]`. */
  moveTo(vertices: Uint32Array, weights: Float64Array, first: number) {
    const { frame } = this
    frame.fill(0)
    for (let axis = 0; axis < 3; axis++) {
      const vectors = this.axes[axis]!
      for (let k = first; k < first + 3; k++) {
        const [weight, from] = [weights[k]!, 3 * vertices[k]!]
        for (let c = 0; c < 3; c++) frame[3 * axis + c]! += weight * vectors[from + c]!
      }
    }
    normalizeVectors(frame)
  }

  /** Writes the vector at `normals[i]` as a colour to `colors[to]`: the direction (x, y, z) for which x T + y B + z N is the normal. */
  encode(normals: Float32Array, i: number, colors: Uint8Array, to: number) {
    const { frame } = this
    // Each coordinate is a quotient of determinants (Cramer's rule); only the sign of the common divisor matters.
    const sign = Math.sign(determinant(frame, 0, frame, 3, frame, 6))
    let x = sign * determinant(normals, i, frame, 3, frame, 6)
    let y = sign * determinant(frame, 0, normals, i, frame, 6)
    let z = sign * determinant(frame, 0, frame, 3, normals, i)
    const length = Math.hypot(x, y, z)
    // Where the warp collapses the surface, or the frame has no volume, the interpolated normal remains.
    if (!(length > 0)) [x, y, z] = [0, 0, 1]
    else {
      z = Math.max(z / length, minZ)
      const side = Math.hypot(x, y)
      const scale = side > 0 ? Math.sqrt(1 - z * z) / side : 0
      ;[x, y] = [x * scale, y * scale]
    }
    colors[to] = Math.round(127.5 * (x + 1))
    colors[to + 1] = Math.round(127.5 * (y + 1))
    colors[to + 2] = Math.round(127.5 * (z + 1))
  }
}

/** Normalizes vectors in place; zero vectors stay. */
export function normalizeVectors(vectors: Float32Array | Float64Array) {
  for (let i = 0; i < vectors.length; i += 3) {
    const length = Math.hypot(vectors[i]!, vectors[i + 1]!, vectors[i + 2]!)
    if (length > 0) for (let k = i; k < i + 3; k++) vectors[k]! /= length
  }
}

type Numbers = Float32Array | Float64Array

/** Returns the determinant of three vectors, each an array and the place of its x. */
const determinant = (a: Numbers, i: number, b: Numbers, j: number, c: Numbers, k: number) =>
  a[i]! * (b[j + 1]! * c[k + 2]! - b[j + 2]! * c[k + 1]!) +
  a[i + 1]! * (b[j + 2]! * c[k]! - b[j]! * c[k + 2]!) +
  a[i + 2]! * (b[j]! * c[k + 1]! - b[j + 1]! * c[k]!)
