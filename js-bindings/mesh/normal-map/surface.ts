// Computes the tangents of a warped mesh, and splits its vertices so that each has one tangent.
import { generateTangents } from '../../wasm/mikktspace.js'
import type { WarpedMesh } from '../bake.js'
import type { Mesh } from '../mesh-arrays.js'

type Rest = WarpedMesh['rest']

/** A mesh before and after a warp, with the same vertices. */
export interface Surface {
  rest: Rest
  warped: Mesh & Required<Pick<Mesh, 'uvs' | 'tangents' | 'indices'>>
}

/**
 * Adds MikkTSpace tangents to the warped mesh, which must have triangles. Since MikkTSpace finds a tangent for each corner of a
 * triangle, a vertex whose corners have different tangents is split, in both meshes. Vertices without a triangle are left out.
 */
export function splitByTangents(rest: Rest, warped: Mesh & Required<Pick<Mesh, 'uvs'>>): Surface {
  const corners =
    warped.indices ?? Uint32Array.from({ length: warped.positions.length / 3 }, (_, i) => i)
  const tangents = tangentsOfCorners(warped, corners)
  const { firstCorners, indices } = mergeCorners(corners, tangents)
  const origins = firstCorners.map((corner) => corners[corner]!)
  return {
    rest: pickAll(rest, origins),
    warped: {
      ...pickAll(warped, origins),
      tangents: pick(tangents, firstCorners, 4),
      indices,
    },
  }
}

/** Returns a tangent for each corner. It is 0 in triangles with two equal positions. */
function tangentsOfCorners(
  { positions, normals, uvs }: Mesh & Required<Pick<Mesh, 'uvs'>>,
  corners: Uint32Array,
): Float32Array {
  // MikkTSpace reads beyond its arrays if a mesh has only triangles with two equal positions, so these are left out.
  const validCorners = Uint32Array.from(corners.keys()).filter((corner) => {
    const first = corner - (corner % 3)
    const [a, b, c] = [corners[first]!, corners[first + 1]!, corners[first + 2]!]
    return !(
      isSameVector(positions, a, b) ||
      isSameVector(positions, b, c) ||
      isSameVector(positions, c, a)
    )
  })
  const tangents = new Float32Array(4 * corners.length)
  if (!validCorners.length) return tangents
  const vertices = validCorners.map((corner) => corners[corner]!)
  // glTF's v increases downwards, MikkTSpace's upwards.
  const upwards = uvs.map((uv, i) => (i % 2 ? 1 - uv : uv))
  const validTangents = generateTangents(
    pick(positions, vertices),
    pick(normals, vertices),
    pick(upwards, vertices, 2),
  )
  validCorners.forEach((corner, i) =>
    tangents.set(validTangents.subarray(4 * i, 4 * i + 4), 4 * corner),
  )
  return tangents
}

function isSameVector(vectors: Float32Array, a: number, b: number, size = 3) {
  for (let k = 0; k < size; k++) if (vectors[size * a + k] !== vectors[size * b + k]) return false
  return true
}

/**
 * Merges corners with the same vertex and tangent into one new vertex. Returns the first corner of each new vertex, and `indices`, the new
 * vertex of each corner.
 */
function mergeCorners(corners: Uint32Array, tangents: Float32Array) {
  const firstCorners: number[] = []
  /** Maps a new vertex → the previous one with the same original, or -1. */
  const previous: number[] = []
  /** Maps an original vertex → the newest vertex that was made from it, or -1. */
  const newest = new Int32Array(corners.reduce((max, vertex) => Math.max(max, vertex), 0) + 1)
  newest.fill(-1)
  const indices = corners.map((vertex, corner) => {
    let candidate = newest[vertex]!
    while (candidate >= 0 && !isSameVector(tangents, firstCorners[candidate]!, corner, 4))
      candidate = previous[candidate]!
    if (candidate >= 0) return candidate
    previous.push(newest[vertex]!)
    newest[vertex] = firstCorners.length
    return firstCorners.push(corner) - 1
  })
  return { firstCorners: Uint32Array.from(firstCorners), indices }
}

/** The number of components per vertex, for arrays that do not have 3. */
const sizes: Record<string, number> = { uvs: 2, colors: 4, tangents: 4 }

/** Returns the mesh with these vertices in this order, and without indices. */
function pickAll<Arrays extends Mesh>({ indices: _, ...mesh }: Arrays, vertices: Uint32Array) {
  const picked = Object.entries(mesh).map(([name, value]) =>
    value instanceof Float32Array ? [name, pick(value, vertices, sizes[name])] : [name, value],
  )
  return Object.fromEntries(picked) as Omit<Arrays, 'indices'>
}

function pick(numbers: Float32Array, vertices: Uint32Array, size = 3): Float32Array {
  const picked = new Float32Array(size * vertices.length)
  for (let i = 0; i < vertices.length; i++)
    for (let k = 0; k < size; k++) picked[size * i + k] = numbers[size * vertices[i]! + k]!
  return picked
}
