// Measures the distance between warped triangles and the warped surface at dense samples, independently of `subdivide`.

/** The number of coordinates that are warped in one call. */
const batchSize = 6e5

/**
 * Returns the maximum distance from a point of the true surface (a warped point of a triangle of `mesh`) to the closest point of the
 * triangle with warped corners. Samples form a lattice in each triangle whose spacing before the warp is at most `spacing`, with at
 * least four steps per side. The warp should compute no normals, since they are not used.
 */
export function deviation(mesh, warp, uniforms, spacing) {
  const warpPositions = (positions) => warp.evaluate({ positions }, { uniforms }).positions
  const corners = warpPositions(mesh.positions)
  let max = 0
  let batch = []
  let positions = new Float32Array(batchSize)
  let filled = 0
  const flush = () => {
    const points = warpPositions(positions.subarray(0, filled))
    let next = 0
    for (const { triangle, steps } of batch)
      for (const [s, t] of lattice(steps)) {
        const sample = point(points, next++)
        // The distance to the interpolated point bounds the distance to the triangle. For most samples, this bound suffices.
        if (length(sub(sample, interpolate(triangle, s, t))) > max)
          max = Math.max(max, distanceToTriangle(sample, triangle))
      }
    batch = []
    filled = 0
  }
  for (let t = 0; t < mesh.indices.length / 3; t++) {
    const cornersIn = (array) =>
      [0, 1, 2].map((corner) => point(array, mesh.indices[3 * t + corner]))
    const before = cornersIn(mesh.positions)
    const [a, b, c] = before
    const longest = Math.max(length(sub(b, a)), length(sub(c, b)), length(sub(a, c)))
    const steps = Math.max(4, Math.ceil(longest / spacing))
    const size = 3 * lattice(steps).length
    if (filled + size > positions.length) {
      flush()
      if (size > positions.length) positions = new Float32Array(size)
    }
    for (const [s, t] of lattice(steps)) {
      positions.set(interpolate(before, s, t), filled)
      filled += 3
    }
    batch.push({ triangle: cornersIn(corners), steps })
  }
  flush()
  return max
}

/**
 * Returns the edges, identified by positions, that are not in exactly `times` triangles. If `times` is 2, these are the cracks of a closed
 * mesh.
 */
export function edgesNotUsed(times, { positions, indices }) {
  const used = new Map()
  const key = (v) => point(positions, v).join()
  for (let i = 0; i < indices.length; i++) {
    const ends = [key(indices[i]), key(indices[i % 3 === 2 ? i - 2 : i + 1])].sort().join('|')
    used.set(ends, (used.get(ends) ?? 0) + 1)
  }
  return [...used].filter(([, count]) => count !== times).map(([ends]) => ends)
}

const point = (array, i) => [array[3 * i], array[3 * i + 1], array[3 * i + 2]]
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
const length = (a) => Math.sqrt(dot(a, a))

const interpolate = ([a, b, c], s, t) => [
  a[0] + s * (b[0] - a[0]) + t * (c[0] - a[0]),
  a[1] + s * (b[1] - a[1]) + t * (c[1] - a[1]),
  a[2] + s * (b[2] - a[2]) + t * (c[2] - a[2]),
]

const lattices = new Map()
function lattice(steps) {
  if (!lattices.has(steps)) {
    const points = []
    for (let i = 0; i <= steps; i++)
      for (let j = 0; j <= steps - i; j++) points.push([i / steps, j / steps])
    lattices.set(steps, points)
  }
  return lattices.get(steps)
}

/** Returns the distance to the plane if the foot of the perpendicular is inside of the triangle, otherwise to the nearest side. */
function distanceToTriangle(p, [a, b, c]) {
  const [ab, ac, ap] = [sub(b, a), sub(c, a), sub(p, a)]
  const [uu, uv, vv] = [dot(ab, ab), dot(ab, ac), dot(ac, ac)]
  const [u, v] = [dot(ap, ab), dot(ap, ac)]
  const area = uu * vv - uv * uv
  const s = (vv * u - uv * v) / area
  const t = (uu * v - uv * u) / area
  if (s >= 0 && t >= 0 && s + t <= 1) return length(sub(p, interpolate([a, b, c], s, t)))
  return Math.min(distanceToSide(p, a, b), distanceToSide(p, b, c), distanceToSide(p, c, a))
}

function distanceToSide(p, a, b) {
  const [side, toPoint] = [sub(b, a), sub(p, a)]
  const squared = dot(side, side)
  const t = squared ? Math.min(1, Math.max(0, dot(toPoint, side) / squared)) : 0
  return length(sub(p, interpolate([a, b, a], t, 0)))
}
