/**
 * Polygonizes the zero set of a field. The input is `field(x, y, z)`, negative inside and close to a
 * signed distance (its slope must not exceed 1 by much, or `sample` would skip blocks that the surface crosses). The output is a
 * mesh with vertices on the surface and normals along the field's gradient.
 *
 * Surface nets (Gibson 1998): one vertex in every grid cell that the surface crosses, one quad
 * across every crossed grid edge. Chosen over marching tetrahedra, because its triangles are well
 * shaped and far fewer for the same grid.
 */

import { createMesh, distance, frontUVs, normalize } from './mesh.js'

const BLOCK = 4

/** Returns the field of the points within a ball that moves from a to b while its radius changes from ra to rb. */
export function roundCone(a, b, ra, rb) {
  const [dx, dy, dz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
  const length = Math.hypot(dx, dy, dz)
  const slope = (rb - ra) / length
  // √(q² + (along - s)²) - (ra + slope s) has its minimum at s = along + q slope / √(1 - slope²).
  const lean = slope / Math.sqrt(1 - slope * slope)
  return (x, y, z) => {
    const px = x - a[0]
    const py = y - a[1]
    const pz = z - a[2]
    const along = (px * dx + py * dy + pz * dz) / length
    const q = Math.sqrt(Math.max(px * px + py * py + pz * pz - along * along, 0))
    const s = Math.min(Math.max(along + q * lean, 0), length)
    return Math.sqrt(q * q + (along - s) ** 2) - ra - slope * s
  }
}

/** Returns the minimum of two distances, rounded where they differ by less than k (by a cubic, so C² continuous). */
export function smoothMin(a, b, k) {
  const h = Math.max(k - Math.abs(a - b), 0) / k
  return Math.min(a, b) - (h * h * h * k) / 6
}

/** Samples the field on the grid; all points of a block that the surface cannot reach get the value at its center. */
function sample(field, { low, size, cell }) {
  const [nx, ny, nz] = size
  const values = new Float32Array(nx * ny * nz)
  const reach = cell * (((BLOCK - 1) / 2) * Math.sqrt(3) + 1)
  for (let bz = 0; bz < nz; bz += BLOCK) {
    for (let by = 0; by < ny; by += BLOCK) {
      for (let bx = 0; bx < nx; bx += BLOCK) {
        const half = (BLOCK - 1) / 2
        const [x, y, z] = [bx + half, by + half, bz + half].map((i, k) => low[k] + i * cell)
        const middle = field(x, y, z)
        const far = Math.abs(middle) > 1.3 * reach
        for (let k = bz; k < Math.min(bz + BLOCK, nz); k++) {
          for (let j = by; j < Math.min(by + BLOCK, ny); j++) {
            for (let i = bx; i < Math.min(bx + BLOCK, nx); i++) {
              values[i + nx * (j + ny * k)] = far
                ? middle
                : field(low[0] + i * cell, low[1] + j * cell, low[2] + k * cell)
            }
          }
        }
      }
    }
  }
  return values
}

/**
 * Returns the mean of the points where the surface crosses the cell's twelve edges, relative to the corner of the cell and in units of its
 * side; null if the surface crosses no edge.
 */
function cellVertex(values, corner, offsets) {
  let inner = 0
  for (let a = 0; a < 8; a++) if (values[corner + offsets[a]] < 0) inner++
  if (inner === 0 || inner === 8) return null
  let count = 0
  const sum = [0, 0, 0]
  for (let a = 0; a < 8; a++) {
    for (let axis = 0; axis < 3; axis++) {
      if (a & (1 << axis)) continue
      const va = values[corner + offsets[a]]
      const vb = values[corner + offsets[a | (1 << axis)]]
      if (va < 0 === vb < 0) continue
      count++
      for (let k = 0; k < 3; k++) sum[k] += k === axis ? va / (va - vb) : (a >> k) & 1
    }
  }
  return sum.map((x) => x / count)
}

function buildSurfaceNet(values, { low, size, cell }) {
  const [nx, ny, nz] = size
  const stride = [1, nx, nx * ny]
  const offsets = Array.from({ length: 8 }, (_, a) =>
    stride.reduce((sum, step, k) => sum + ((a >> k) & 1) * step, 0),
  )
  const points = []
  const vertexOf = new Int32Array(values.length).fill(-1)
  const quads = []
  for (let k = 0; k < nz - 1; k++) {
    for (let j = 0; j < ny - 1; j++) {
      for (let i = 0; i < nx - 1; i++) {
        const corner = i + nx * (j + ny * k)
        const vertex = cellVertex(values, corner, offsets)
        if (!vertex) continue
        vertexOf[corner] = points.length
        points.push([i, j, k].map((c, axis) => low[axis] + (c + vertex[axis]) * cell))
        // The other cells around this corner's three edges have all been visited.
        for (let axis = 0; axis < 3; axis++) {
          const inner = values[corner] < 0
          if (inner === values[corner + stride[axis]] < 0) continue
          const [u, v] = [stride[(axis + 1) % 3], stride[(axis + 2) % 3]]
          const quad = [corner, corner - u, corner - u - v, corner - v].map((c) => vertexOf[c])
          quads.push(inner ? quad : quad.reverse())
        }
      }
    }
  }
  return { points, quads }
}

/** Splits each quad into two triangles along its shorter diagonal. */
function splitQuads(quads, points) {
  return quads.flatMap(([a, b, c, d]) =>
    distance(points[a], points[c]) < distance(points[b], points[d])
      ? [
          [a, b, c],
          [a, c, d],
        ]
      : [
          [a, b, d],
          [b, c, d],
        ],
  )
}

/** Estimates ∇f from four values at the corners of a tetrahedron. */
function estimateGradient(field, [x, y, z], e = 0.05) {
  const a = field(x + e, y - e, z - e)
  const b = field(x - e, y - e, z + e)
  const c = field(x - e, y + e, z - e)
  const d = field(x + e, y + e, z + e)
  const s = 1 / (4 * e)
  return [(a - b - c + d) * s, (c + d - a - b) * s, (b + d - a - c) * s]
}

/** Moves a point onto the surface: one Newton step along the gradient. */
function project(field, p) {
  const g = estimateGradient(field, p)
  const step = field(p[0], p[1], p[2]) / (g[0] * g[0] + g[1] * g[1] + g[2] * g[2])
  return [p[0] - step * g[0], p[1] - step * g[1], p[2] - step * g[2]]
}

/** Moves each point to the mean of its neighbours and back to the surface, which evens out the triangles. */
function relax(field, points, quads) {
  const sums = points.map(() => [0, 0, 0, 0])
  for (const quad of quads) {
    quad.forEach((from, k) => {
      for (const to of [quad[(k + 1) % 4], quad[(k + 3) % 4]]) {
        for (let axis = 0; axis < 3; axis++) sums[from][axis] += points[to][axis]
        sums[from][3]++
      }
    })
  }
  return sums.map(([x, y, z, n]) => project(field, [x / n, y / n, z / n]))
}

/**
 * @param field (x, y, z) -> number, negative inside
 * @param low, high corners of a box that contains the whole surface
 * @param cell  size of a grid cell, which is about the distance between neighbouring vertices
 */
export function polygonize(field, { low, high, cell }) {
  const size = low.map((x, k) => Math.ceil((high[k] - x) / cell) + 1)
  const grid = { low, size, cell }
  const net = buildSurfaceNet(sample(field, grid), grid)
  let points = net.points
  for (let i = 0; i < 2; i++) points = relax(field, points, net.quads)
  points = points.map((p) => project(field, p))
  const normals = points.map((p) => normalize(estimateGradient(field, p)))
  return createMesh({
    points,
    normals,
    uvs: frontUVs(points),
    triangles: splitQuads(net.quads, points),
  })
}
