/**
 * Lofts a closed surface through sections: fuselage, wing, spoon and propeller blade are all lofts.
 * The input is a function `section(s, t) -> [x, y, z]`, where s in [0, 1] goes along the body and t in
 * [0, 1] once around it; at s = 0 and s = 1 the section shrinks to a point. The output is a mesh
 * whose vertices are about `spacing` apart everywhere.
 *
 * A plain grid in (s, t) would crowd its vertices where the body is slim and stretch its triangles
 * where it is wide, and a warp makes both visible. So the number of vertices of each ring follows
 * from its length, and neighbouring rings with different counts are stitched.
 */

import { createMesh, cross, distance, dot, normalize, sub } from './mesh.js'

const FINE_RINGS = 200
const FINE_AROUND = 120
// The max turn in radians between two vertices, so that edges stay round.
const TURN = 0.42
// The max density of vertices, relative to that of `spacing`, even where more would be rounder: slivers look worse than facets.
const MAX_DENSITY = 2.2
const STEP = 1e-4

/**
 * Weights each segment of a polyline by the number of vertices it should get, from its length and
 * from the turn at its start.
 */
function weighSegments(points, spacing, isClosed) {
  const directions = points.slice(1).map((p, i) => normalize(sub(p, points[i])))
  return directions.map((direction, i) => {
    const length = distance(points[i], points[i + 1]) / spacing
    const before = i > 0 ? directions[i - 1] : isClosed ? directions.at(-1) : direction
    const turn = Math.acos(Math.min(1, Math.max(-1, dot(before, direction)))) / TURN
    return Math.min(Math.hypot(length, turn), MAX_DENSITY * length)
  })
}

/** Returns the parameters in [0, 1] that cut a line with these weights into `count` equal pieces. */
function cutEvenly(pieces, count) {
  const total = pieces.reduce((sum, piece) => sum + piece, 0)
  const result = [0]
  let sum = 0
  for (let i = 0; i < pieces.length && result.length < count; i++) {
    while (result.length < count && sum + pieces[i] >= (total * result.length) / count) {
      const inside = ((total * result.length) / count - sum) / pieces[i]
      result.push((i + inside) / pieces.length)
    }
    sum += pieces[i]
  }
  return [...result, 1]
}

/** Returns the s of each ring. In each piece of the body, the meridian that needs most rings decides their spacing. */
function ringPositions(section, spacing) {
  const longest = new Array(FINE_RINGS).fill(0)
  for (let k = 0; k < 16; k++) {
    const line = Array.from({ length: FINE_RINGS + 1 }, (_, i) => section(i / FINE_RINGS, k / 16))
    weighSegments(line, spacing, false).forEach((weight, i) => {
      longest[i] = Math.max(longest[i], weight)
    })
  }
  const count = Math.round(longest.reduce((sum, weight) => sum + weight, 0))
  return cutEvenly(longest, Math.max(count, 4))
}

/** Returns the t of each vertex of the ring at s. */
function ringVertices(section, s, spacing) {
  const line = Array.from({ length: FINE_AROUND + 1 }, (_, i) => section(s, i / FINE_AROUND))
  const pieces = weighSegments(line, spacing, true)
  const count = pieces.reduce((sum, piece) => sum + piece, 0)
  // Even counts keep a symmetric section symmetric.
  return cutEvenly(pieces, Math.max(2 * Math.round(count / 2), 6))
}

/** Returns ∂/∂s × ∂/∂t, normalized, by central differences; at a sharp seam, ∂/∂t is one-sided. */
function surfaceNormal(section, s, t, sharp) {
  const wrap = (x) => x - Math.floor(x)
  const before = sharp ? Math.max(t - STEP, 0) : wrap(t - STEP)
  const after = sharp ? Math.min(t + STEP, 1) : wrap(t + STEP)
  const alongS = sub(section(Math.min(s + STEP, 1), t), section(Math.max(s - STEP, 0), t))
  const alongT = sub(section(s, after), section(s, before))
  return normalize(cross(alongS, alongT))
}

/** Returns the normal of a pole: ∂/∂t vanishes there, so it is the mean of the normals just beside the pole. */
function poleNormal(section, s) {
  const nearby = s === 0 ? 4 * STEP : 1 - 4 * STEP
  const sum = [0, 0, 0]
  for (let k = 0; k < 12; k++) {
    const n = surfaceNormal(section, nearby, (k + 0.5) / 12, false)
    for (let axis = 0; axis < 3; axis++) sum[axis] += n[axis]
  }
  return normalize(sum)
}

/**
 * Adds triangles between two rings of vertex indices, always along the shorter of the two diagonals.
 */
function stitch(a, b, points, triangles) {
  const [n, m] = [a.length - 1, b.length - 1]
  // Always choosing the shorter diagonal must not let one ring get ahead of the other by more than a step.
  const lead = 1.01 / Math.max(Math.min(n, m), 1)
  for (let i = 0, j = 0; i < n || j < m;) {
    const ahead = (i + 1) / n - j / m
    const behind = (j + 1) / m - i / n
    let first = i < n
    if (i < n && j < m) {
      const shorter =
        distance(points[a[i + 1]], points[b[j]]) <= distance(points[a[i]], points[b[j + 1]])
      first = ahead > lead ? false : behind > lead ? true : shorter
    }
    if (first) triangles.push([a[i], b[j], a[++i]])
    else triangles.push([a[i], b[j], b[++j]])
  }
}

function signedVolume(points, triangles) {
  return triangles.reduce(
    (sum, [a, b, c]) => sum + dot(points[a], cross(points[b], points[c])) / 6,
    0,
  )
}

/**
 * @param section (s, t) -> point: closed in t; at s = 0, and at s = 1, the same point for all t
 * @param spacing the desired distance between neighbouring vertices, in model units
 * @param sharp   true if t = 0 is a crease (the trailing edge of a wing)
 */
export function loft(section, { spacing, sharp = false }) {
  const points = []
  const normals = []
  const uvs = []
  const add = (point, normal, uv) => {
    normals.push(normal)
    uvs.push(uv)
    return points.push(point) - 1
  }
  const positions = ringPositions(section, spacing)
  const rings = positions.map((s, i) => {
    const u = i / (positions.length - 1)
    if (s === 0 || s === 1) return [add(section(s, 0), poleNormal(section, s), [u, 0.5])]
    // The two vertices of the seam have the same position and different texture coordinates.
    const ring = ringVertices(section, s, spacing)
    return ring.map((t) =>
      add(section(s, t === 1 ? 0 : t), surfaceNormal(section, s, t, sharp), [u, t]),
    )
  })
  const triangles = []
  for (let i = 1; i < rings.length; i++) stitch(rings[i - 1], rings[i], points, triangles)

  // ∂/∂s × ∂/∂t points outwards or inwards, depending on the direction of the section.
  if (signedVolume(points, triangles) < 0) {
    triangles.forEach((triangle) => triangle.reverse())
    normals.forEach((normal, i) => (normals[i] = normal.map((x) => -x)))
  }
  return createMesh({ points, normals, uvs, triangles })
}
