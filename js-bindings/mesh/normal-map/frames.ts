// The tangent frames of a mesh, and the colours that encode normals relative to them.
import type { Surface } from './surface.js'

/** The min z of a normal in its map: glTF allows no smaller ones, which would point to the other side of the surface. */
const minZ = 1 / 255

/** The ways in which programs interpolate the frame between vertices; `NormalMapOptions` documents them. */
export type FrameKind = 'normalized' | 'mikktspace'

/** Interpolates the tangent frame, at one point of the mesh at a time. */
export class TangentFrames {
  private readonly tangents: Float32Array
  private readonly bitangents: Float32Array
  private readonly normals: Float32Array
  /** Tangent, bitangent and normal at the point. */
  private readonly frame = new Float64Array(9)

  constructor(
    { normals, tangents }: Surface['warped'],
    private readonly kind: FrameKind,
  ) {
    this.normals = normals
    this.tangents = normals.map((_, i) => tangents[4 * Math.floor(i / 3) + (i % 3)]!)
    this.bitangents = new Float32Array(normals.length)
    for (let i = 0; i < normals.length; i += 3)
      setCross(this.bitangents, i, normals, i, this.tangents, i, tangents[(4 * i) / 3 + 3]!)
    normalizeVectors(this.bitangents)
  }

  /** Interpolates the frame between three vertices, with indices from `vertices[first]` and weights from `weights[first]`. */
  moveTo(vertices: Uint32Array, weights: Float64Array, first: number) {
    const { frame, tangents, bitangents, normals } = this
    frame.fill(0)
    for (let k = first; k < first + 3; k++) {
      const [weight, start] = [weights[k]!, 3 * vertices[k]!]
      for (let c = 0; c < 3; c++) {
        frame[c]! += weight * tangents[start + c]!
        frame[3 + c]! += weight * bitangents[start + c]!
        frame[6 + c]! += weight * normals[start + c]!
      }
    }
    if (this.kind === 'normalized') return normalizeVectors(frame)
    // The bitangent is on the same side at all vertices of a triangle, so also between them.
    const side = determinant(frame, 0, frame, 3, frame, 6) < 0 ? -1 : 1
    setCross(frame, 3, frame, 6, frame, 0, side)
  }

  /**
   * Writes the normal at `normals[i]` as a colour to `colors[target]`: the direction (x, y, z) for which x T + y B + z N, with the tangent
   * T, bitangent B and normal N of the frame, has the direction of the normal.
   */
  encode(normals: Float32Array, i: number, colors: Uint8Array, target: number) {
    const { frame } = this
    // Each coordinate is a quotient of determinants (Cramer's rule); only the sign of the common divisor matters.
    const sign = Math.sign(determinant(frame, 0, frame, 3, frame, 6))
    let x = sign * determinant(normals, i, frame, 3, frame, 6)
    let y = sign * determinant(frame, 0, normals, i, frame, 6)
    let z = sign * determinant(frame, 0, frame, 3, normals, i)
    const length = Math.sqrt(x * x + y * y + z * z)
    // The interpolated normal N is used where the warp collapses the surface or the frame has no volume.
    if (!(length > 0)) [x, y, z] = [0, 0, 1]
    else {
      z = Math.max(z / length, minZ)
      const tangential = Math.sqrt(x * x + y * y)
      const scale = tangential > 0 ? Math.sqrt(1 - z * z) / tangential : 0
      ;[x, y] = [x * scale, y * scale]
    }
    colors[target] = Math.round(127.5 * (x + 1))
    colors[target + 1] = Math.round(127.5 * (y + 1))
    colors[target + 2] = Math.round(127.5 * (z + 1))
  }
}

/** Normalizes vectors in place; zero vectors stay zero. Math.hypot would take several times as long. */
export function normalizeVectors(vectors: Float32Array | Float64Array) {
  for (let i = 0; i < vectors.length; i += 3) {
    const [x, y, z] = [vectors[i]!, vectors[i + 1]!, vectors[i + 2]!]
    const length = Math.sqrt(x * x + y * y + z * z)
    if (length > 0) for (let k = i; k < i + 3; k++) vectors[k]! /= length
  }
}

/** Writes a multiple of the cross product of the vectors at b[j] and c[k] to a[i]. */
function setCross(
  a: Numbers,
  i: number,
  b: Numbers,
  j: number,
  c: Numbers,
  k: number,
  factor: number,
) {
  a[i] = factor * (b[j + 1]! * c[k + 2]! - b[j + 2]! * c[k + 1]!)
  a[i + 1] = factor * (b[j + 2]! * c[k]! - b[j]! * c[k + 2]!)
  a[i + 2] = factor * (b[j]! * c[k + 1]! - b[j + 1]! * c[k]!)
}

type Numbers = Float32Array | Float64Array

/** Returns the determinant of three vectors, each given by an array and the index of its x there. */
const determinant = (a: Numbers, i: number, b: Numbers, j: number, c: Numbers, k: number) =>
  a[i]! * (b[j + 1]! * c[k + 2]! - b[j + 2]! * c[k + 1]!) +
  a[i + 1]! * (b[j + 2]! * c[k]! - b[j]! * c[k + 2]!) +
  a[i + 2]! * (b[j]! * c[k + 1]! - b[j + 1]! * c[k]!)
