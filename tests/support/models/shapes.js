// Small shapes, and comparisons of their triangles.
import { grid, sphere } from '../meshes.js'

function makeCube() {
  const [positions, normals, uvs, indices] = [[], [], [], []]
  for (let axis = 0; axis < 3; axis++)
    for (const side of [-1, 1]) {
      const first = positions.length / 3
      for (const [a, b] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]) {
        const point = [0, 0, 0]
        point[axis] = side
        point[(axis + 1) % 3] = a * side
        point[(axis + 2) % 3] = b
        positions.push(...point)
        normals.push(...[0, 1, 2].map((k) => (k === axis ? side : 0)))
        uvs.push((a + 1) / 2, (b + 1) / 2)
      }
      indices.push(...[0, 1, 2, 0, 2, 3].map((corner) => first + corner))
    }
  return { positions, normals, uvs, indices }
}

/** Makes a tetrahedron: the closed shape with the fewest triangles, which share no vertices. */
function makeTetrahedron() {
  const points = [
    [1, 1, 1],
    [-1, -1, 1],
    [-1, 1, -1],
    [1, -1, -1],
  ]
  const faces = [
    [0, 2, 1],
    [0, 1, 3],
    [0, 3, 2],
    [1, 2, 3],
  ]
  const corners = faces.flat()
  const normals = faces.flatMap((face) => {
    const sum = [0, 1, 2].map((k) => face.reduce((total, i) => total + points[i][k], 0))
    return [sum, sum, sum].flat().map((x) => x / Math.sqrt(3))
  })
  return {
    positions: corners.flatMap((i) => points[i]),
    normals,
    uvs: corners.flatMap((i) => [i / 4, 0.5]),
    indices: corners.map((_, i) => i),
  }
}

const withUvs = (mesh) => ({
  ...mesh,
  uvs: [...mesh.positions].filter((_, i) => i % 3 < 2).map((x) => x / 4),
})

const toTypedArrays = ({ positions, normals, uvs, indices }) => ({
  positions: Float32Array.from(positions),
  normals: Float32Array.from(normals),
  uvs: Float32Array.from(uvs),
  indices: Uint32Array.from(indices),
})

export const shapes = {
  cube: toTypedArrays(makeCube()),
  tetrahedron: toTypedArrays(makeTetrahedron()),
  sphere: toTypedArrays(sphere(8, 6)),
  grid: toTypedArrays(withUvs(grid(4, 3))),
}

/** Lists the corners of each triangle, 3 × 3 numbers; `move(position, vertex)` moves a corner. */
export function trianglesOf({ positions, indices }, move = (corner) => corner) {
  const corners = [...(indices ?? Array(positions.length / 3).keys())]
  const points = corners.map((i) => move([...positions.slice(3 * i, 3 * i + 3)], i))
  return Array.from({ length: points.length / 3 }, (_, i) => points.slice(3 * i, 3 * i + 3))
}

/** Reverses triangles, as mirroring does. */
export const reverseTriangles = (triangles) => triangles.map(([a, b, c]) => [a, c, b])

/** Tests whether a triangle has no area, like some at the poles of a sphere. */
function isFlat([a, b, c]) {
  const [u, v] = [b, c].map((point) => point.map((x, k) => x - a[k]))
  const normal = [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3]
    return u[i] * v[j] - u[j] * v[i]
  })
  return Math.hypot(...normal) < 1e-4
}

const distance = (a, b) => Math.max(...a.flatMap((p, i) => p.map((x, k) => Math.abs(x - b[i][k]))))
const rotateCorners = ([a, b, c], shift) =>
  [
    [a, b, c],
    [b, c, a],
    [c, a, b],
  ][shift]

/**
 * Returns the max distance of a corner from its expected position, or a message if the files have different numbers of triangles. The
 * triangles may be in any order and start at any corner; those without area do not count.
 */
export function compareTriangles(actual, expected) {
  const [triangles, unmatched] = [actual, expected].map((list) =>
    list.filter((triangle) => !isFlat(triangle)),
  )
  if (triangles.length !== unmatched.length)
    return `expected ${unmatched.length} triangles, got ${triangles.length}`
  let worst = 0
  for (const triangle of triangles) {
    let best = { error: Infinity, place: -1 }
    unmatched.forEach((other, place) => {
      for (const shift of [0, 1, 2]) {
        const error = distance(triangle, rotateCorners(other, shift))
        if (error < best.error) best = { error, place }
      }
    })
    unmatched.splice(best.place, 1)
    worst = Math.max(worst, best.error)
  }
  return worst
}
