/**
 * How normal and uv vary over a shape of which nothing is known but its triangles. What a sketch built may have a hundred thousand
 * vertices, and its first frame waits for this: hence arrays of numbers.
 */
import type { Shape } from '../host.js'
import { type Triple, cross, dot, sub, times } from '../geometry/triple.js'

/** By vertex: three numbers of its position, then what varies, which are three of its normal, u and v. */
const width = 8
const [normal, uv] = [3, 6]

/**
 * By value that varies, its gradient at each vertex: the mean of the triangles around, in the tangent plane, with the weights that make
 * the normals of a sphere exact (Max, "Weights for Computing Vertex Normals from Facet Normals", 1999).
 */
export function byTriangles(shape: Shape): Float32Array[] {
  const vertices = tableOf(shape)
  const owners = ownersOf(vertices)
  const sums = sumsAround(shape.faces, vertices, owners)
  return sums.map((sum, k) => tangential(sum, vertices, owners[k]!))
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
 * By value that varies and vertex, the vertex that has its gradient: those of one place and normal share what the normal does, and what
 * the uvs do where these only begin anew, so that such a seam is none of the light. A hash table of numbers instead of the texts takes
 * a quarter to a third off the whole and adds forty lines.
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

/** By value that varies, for each owner: the sum of the gradients in the triangles around, times weights, and that of the weights. */
function sumsAround(
  faces: readonly (readonly number[])[],
  vertices: Float64Array,
  owners: readonly Int32Array[],
): Float64Array[] {
  const length = vertices.length / width
  const sums = owners.map(() => new Float64Array(4 * length))
  for (const face of faces) {
    // As a sketch may make them.
    if (!face.every((i) => i >= 0 && i < length)) continue
    const triangle = slopesIn(face.map((i) => tripleAt(vertices, width * i)))
    if (!triangle) continue
    const { slopes, weights } = triangle
    sums.forEach((sum, k) => {
      const at = face.map((i) => 4 * owners[k]![i]!)
      for (let axis = 0; axis < 3; axis++) {
        let value = 0
        for (let j = 0; j < 3; j++)
          value += slopes[j]![axis]! * vertices[width * face[j]! + normal + k]!
        for (let j = 0; j < 3; j++) sum[at[j]! + axis]! += weights[j]! * value
      }
      for (let j = 0; j < 3; j++) sum[at[j]! + 3]! += weights[j]!
    })
  }
  return sums
}

/** By corner, the gradient of what is 1 there and 0 at the others, and the corner's weight; undefined where two are at one place. */
function slopesIn(corners: readonly Triple[]) {
  const [a, b, c] = corners as readonly [Triple, Triple, Triple]
  const opposite = [sub(c, b), sub(a, c), sub(b, a)] as const
  const squares = opposite.map((edge) => dot(edge, edge))
  const up = cross(opposite[0], opposite[1])
  const square = dot(up, up)
  // As p5 has them at poles and seams, but for rounding errors.
  if (!(square > 1e-12 * Math.max(...squares) ** 2)) return
  const all = squares[0]! * squares[1]! * squares[2]!
  return {
    slopes: opposite.map((edge) => times(cross(up, edge), 1 / square)),
    // Its sine over the lengths of its two sides.
    weights: squares.map((each) => (each * Math.sqrt(square)) / all),
  }
}

/** By vertex, the mean that its owner has, without what stands out of the surface. */
function tangential(sums: Float64Array, vertices: Float64Array, owners: Int32Array): Float32Array {
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
