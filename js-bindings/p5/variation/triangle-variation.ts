/**
 * Gradients of normal and uv on a shape of which we know only the triangles. A shape built by a sketch may have a hundred thousand
 * vertices, and its first frame waits for this computation: hence typed arrays.
 */
import { cross, dot, sub, times, type Triple } from '../geometry/triple.js'
import type { Shape } from '../host.js'

/** Numbers per vertex: 3 of its position, then the varying values: 3 of its normal, u and v. */
const width = 8
/** The columns where the normal and uv start. */
const [normal, uv] = [3, 6]

/**
 * Returns the gradient of each varying value at each vertex: the mean over the surrounding triangles, in the tangent plane, with the
 * weights that make the normals of a sphere exact (Max, "Weights for Computing Vertex Normals from Facet Normals", 1999).
 */
export function gradientsByTriangles(shape: Shape): Float32Array[] {
  const vertices = tableOf(shape)
  const owners = ownersOf(vertices)
  const sums = sumsAround(shape.faces, vertices, owners)
  return sums.map((sum, k) => projectMeans(sum, vertices, owners[k]!))
}

function tableOf({ vertices, vertexNormals, uvs }: Shape): Float64Array {
  const table = new Float64Array(width * vertices.length)
  const flat = uvs.flat()
  vertices.forEach(({ x, y, z }, i) => {
    const n = vertexNormals[i]
    table.set(
      [x, y, z, n?.x ?? 0, n?.y ?? 0, n?.z ?? 0, flat[2 * i] ?? 0, flat[2 * i + 1] ?? 0],
      width * i,
    )
  })
  return table
}

/**
 * Maps each varying value and vertex to the vertex that stores its gradient. Vertices with the same position and normal share the
 * gradients of the normal. They also share those of uv if their uvs differ by whole numbers, so that no seam shows in the light. A hash
 * table with numeric keys instead of strings would take a quarter to a third off the total time and add forty lines.
 */
function ownersOf(vertices: Float64Array): Int32Array[] {
  const rounded = vertices.map((x, at) => Math.round((at % width < uv ? x : x % 1) * 1e6))
  const [byNormal, byUv] = [uv, width].map((columns) => {
    const first = new Map<string, number>()
    return Int32Array.from({ length: vertices.length / width }, (_, i) => {
      const key = rounded.subarray(width * i, width * i + columns).join()
      if (!first.has(key)) first.set(key, i)
      return first.get(key)!
    })
  })
  return [byNormal!, byNormal!, byNormal!, byUv!, byUv!]
}

/**
 * Returns 4 numbers per owner for each varying value: the weighted sum of the gradients in the surrounding triangles, and the sum of the
 * weights.
 */
function sumsAround(
  faces: readonly (readonly number[])[],
  vertices: Float64Array,
  owners: readonly Int32Array[],
): Float64Array[] {
  const length = vertices.length / width
  const sums = owners.map(() => new Float64Array(4 * length))
  for (const face of faces) {
    // A sketch may make faces with invalid indices.
    if (!face.every((i) => i >= 0 && i < length)) continue
    const triangle = slopesIn(face.map((i) => tripleAt(vertices, width * i)))
    if (!triangle) continue
    const { slopes, weights } = triangle
    sums.forEach((sum, k) => {
      const starts = face.map((i) => 4 * owners[k]![i]!)
      for (let axis = 0; axis < 3; axis++) {
        let value = 0
        for (let j = 0; j < 3; j++)
          value += slopes[j]![axis]! * vertices[width * face[j]! + normal + k]!
        for (let j = 0; j < 3; j++) sum[starts[j]! + axis]! += weights[j]! * value
      }
      for (let j = 0; j < 3; j++) sum[starts[j]! + 3]! += weights[j]!
    })
  }
  return sums
}

/** Returns the gradient of each corner's barycentric coordinate and the corner's weight; `undefined` for a degenerate triangle. */
function slopesIn(corners: readonly Triple[]) {
  const [a, b, c] = corners as readonly [Triple, Triple, Triple]
  const opposite = [sub(c, b), sub(a, c), sub(b, a)] as const
  const squares = opposite.map((edge) => dot(edge, edge))
  const up = cross(opposite[0], opposite[1])
  const square = dot(up, up)
  // p5's shapes have degenerate triangles at poles and seams, up to rounding errors.
  if (!(square > 1e-12 * Math.max(...squares) ** 2)) return
  const product = squares[0]! * squares[1]! * squares[2]!
  return {
    slopes: opposite.map((edge) => times(cross(up, edge), 1 / square)),
    // The sine of the corner's angle, divided by the lengths of its two sides.
    weights: squares.map((each) => (each * Math.sqrt(square)) / product),
  }
}

/** Returns for each vertex the mean gradient that its owner stores, projected onto the tangent plane. */
function projectMeans(
  sums: Float64Array,
  vertices: Float64Array,
  owners: Int32Array,
): Float32Array {
  const gradients = new Float32Array(3 * owners.length)
  owners.forEach((owner, i) => {
    const n = tripleAt(vertices, width * i + normal)
    const mean = times(tripleAt(sums, 4 * owner), 1 / (sums[4 * owner + 3]! || 1))
    gradients.set(sub(mean, times(n, dot(mean, n) / dot(n, n) || 0)), 3 * i)
  })
  return gradients
}

const tripleAt = (numbers: Float64Array, at: number): Triple => [
  numbers[at]!,
  numbers[at + 1]!,
  numbers[at + 2]!,
]
