// The true light at corners of triangles in a picture of a warped shape: which corners are seen, where, and their normals from differences
// in double of the shapes of p5-surfaces.js.
import * as m from './matrix.js'

/** The size of the picture, and the distance of the eye, in pixels. */
export const [size, distance] = [520, 1500]

/** The scale of offsets for p5's own shapes, which have size 1 in local space. */
export const unit = { height: 1, length: 1, normals: 1 }

/** Parametrizes a triangle by two parameters, with normal and uv interpolated from its corners. */
function flat([a, b, c], [n], [ta, tb, tc]) {
  const mix = (s, t) => (x, k) => x[0][k] * (1 - s - t) + x[1][k] * s + x[2][k] * t
  return {
    at: (s, t) => ({
      p: [0, 1, 2].map((k) => mix(s, t)([a, b, c], k)),
      n,
      uv: [0, 1].map((k) => mix(s, t)([ta, tb, tc], k)),
    }),
  }
}

/** Returns for each triangle its corners as { p, n, side, where }: the surface and the parameters of the corner. */
export function trianglesOf({ vertices, normals, uvs, faces }, { sides }) {
  return faces.map((face) => {
    const of = (list) => face.map((i) => list[i])
    const pairs = face.map((i) => [uvs[2 * i] ?? 0, uvs[2 * i + 1] ?? 0])
    const corner = (j) => ({ vertex: face[j], p: of(vertices)[j], n: of(normals)[j] })
    if (!sides) {
      const side = flat(of(vertices), of(normals), pairs)
      return [0, 1, 2].map((j) => ({
        ...corner(j),
        side,
        where: [
          [0, 0],
          [1, 0],
          [0, 1],
        ][j],
      }))
    }
    return [0, 1, 2].map((j) => {
      const { p, n } = corner(j)
      for (const side of sides) {
        const where = side.of(p, m.normalize(n), pairs[j])
        if (where) return { ...corner(j), side, where }
      }
      throw new Error(`no side has the normal ${n}`)
    })
  })
}

/** Returns the true outward normal at a corner after `move`; where the surface has none, the normal at a nearby point. */
function trueNormal({ side, where: [u, v], n }, move, turn) {
  const near = side.edges ? 1e-6 : 0
  v = Math.min(1 - near, Math.max(near, v))
  const step = 1e-7
  const slopes = (place) => [
    m.subtract(place(u + step, v), place(u - step, v)),
    m.subtract(place(u, v + step), place(u, v - step)),
  ]
  const across = m.cross(...slopes((s, t) => side.at(s, t).p))
  const turned = m.cross(...slopes((s, t) => move(side.at(s, t))))
  return m.turnNormal(turn, m.normalize(m.dot(across, n) < 0 ? turned.map((x) => -x) : turned))
}

/** Returns where u has no derivative, so that an offset that depends on u tears the surface. */
export const isTorn = ({ side, where: [, v] }) =>
  side.edges?.some((edge) => Math.abs(v - edge) < 1e-9)

/** On p5's own cones the light is exact up to the apex; at a torn pole the normal depends on the direction of approach. */
const isLost = (corner, { isBuilt, sides }) => isTorn(corner) && (isBuilt || sides.length === 1)

const toScreen = ([x, y, z]) => [x, y].map((k) => size / 2 + (distance * k) / (distance - z))

const interpolate = (weights, vectors) =>
  vectors[0].map((_, k) => vectors.reduce((sum, vector, i) => sum + weights[i] * vector[k], 0))

/** Returns for each pixel the index of the frontmost triangle, -1 if there is none. */
function firstSeen(triangles) {
  const first = new Int32Array(size * size).fill(-1)
  const nearest = new Float64Array(size * size)
  triangles.forEach((places, id) => {
    const [[ax, ay], [bx, by], [cx, cy]] = places.map(toScreen)
    const whole = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if (Math.abs(whole) < 1e-9) return
    // These values are linear in screen space.
    const [nearA, nearB, nearC] = places.map(([, , z]) => 1 / (distance - z))
    const [left, right] = pixelsAcross(ax, bx, cx)
    const [top, bottom] = pixelsAcross(ay, by, cy)
    // Avoids arrays in the inner loop, which runs for 20 million pixels.
    for (let y = top; y < bottom; y++)
      for (let x = left; x < right; x++) {
        const [px, py] = [x + 0.5, y + 0.5]
        const a = ((cx - bx) * (py - by) - (cy - by) * (px - bx)) / whole
        const b = ((ax - cx) * (py - cy) - (ay - cy) * (px - cx)) / whole
        const c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / whole
        if (a < 0 || b < 0 || c < 0) continue
        const near = a * nearA + b * nearB + c * nearC
        if (near <= nearest[y * size + x]) continue
        nearest[y * size + x] = near
        first[y * size + x] = id
      }
  })
  return first
}

const pixelsAcross = (...ends) => [
  Math.max(0, Math.floor(Math.min(...ends))),
  Math.min(size, Math.ceil(Math.max(...ends))),
]

/**
 * Finds points near each corner of each visible triangle in the picture from `[x, y]` such that the neighbourhood is one smooth
 * surface, with the normal interpolated from true vertex normals.
 */
export function seenCorners(triangles, shape, offset, [aboutX, aboutY]) {
  const { grain = unit, scale = [1, 1, 1] } = shape
  const turn = m.product(m.rotation(aboutX, 1, 2), m.rotation(aboutY, 2, 0), m.scaling(...scale))
  const move = ({ p, n, uv }) => {
    const scaled = p.map((x) => x / grain.length)
    return m.add(p, offset.at(scaled, n, uv, grain))
  }
  const places = triangles.map((corners) =>
    corners.map(({ p, n, side, where }) =>
      m.movePoint(turn, move({ p, n, uv: side.at(...where).uv })),
    ),
  )
  const first = firstSeen(places)
  return triangles.flatMap((corners, id) => {
    const isSmooth = (x, y) => {
      const other = triangles[first[y * size + x]]
      return other?.some(({ vertex }) => corners.some((corner) => corner.vertex === vertex))
    }
    if (corners.some((corner) => isLost(corner, shape))) return []
    return [0, 1, 2].flatMap((j) => {
      const weights = [0, 1, 2].map((i) => (i === j ? 0.8 : 0.1))
      const at = toScreen(interpolate(weights, places[id]))
      // The four pixels that `colorAt` interpolates.
      const [column, row] = at.map((x) => Math.floor(x - 0.5))
      for (const x of [0, 1])
        for (const y of [0, 1]) if (first[(row + y) * size + column + x] !== id) return []
      for (const x of [-1, 0, 1, 2])
        for (const y of [-1, 0, 1, 2]) if (!isSmooth(column + x, row + y)) return []
      const normals = corners.map((corner) => trueNormal(corner, move, turn))
      // If neighbouring pixels differ much, as on triangles seen edge-on, the picture is too coarse to compare.
      const screen = places[id].map(toScreen)
      const steepest = Math.max(
        ...[0, 1, 2].map((i) => {
          const next = (i + 1) % 3
          const step = Math.hypot(...m.subtract(normals[next], normals[i]))
          return step / Math.hypot(screen[next][0] - screen[i][0], screen[next][1] - screen[i][1])
        }),
      )
      if (steepest > 0.04) return []
      const normal = m.normalize(interpolate(weights, normals))
      return Math.min(...normal) > 0.1 ? [{ normal, at, ...corners[j] }] : []
    })
  })
}
