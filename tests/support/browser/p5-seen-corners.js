// The exact normals at corners of triangles in a picture of a warped shape: finds which corners are visible and where, and computes their
// normals from finite differences, in double precision, of the shapes of p5-surfaces.js.
import * as m from './matrix.js'

/** The size of the picture, and the distance of the eye, in pixels. */
export const [size, distance] = [520, 1500]

/**
 * The `grain` of p5's own shapes, which have size 1 in local space. A grain says how an offset is scaled to the size of a shape (see
 * `surfaces` in p5-surfaces.js).
 */
export const unit = { height: 1, length: 1, normals: 1 }

/** Parametrizes a flat triangle: a constant normal, and positions and uvs interpolated between its corners. */
function parametrizeTriangle([a, b, c], [n], [ta, tb, tc]) {
  const mix = (s, t) => (x, k) => x[0][k] * (1 - s - t) + x[1][k] * s + x[2][k] * t
  return {
    at: (s, t) => ({
      p: [0, 1, 2].map((k) => mix(s, t)([a, b, c], k)),
      n,
      uv: [0, 1].map((k) => mix(s, t)([ta, tb, tc], k)),
    }),
  }
}

/**
 * Returns for each triangle its corners as { vertex, p, n, side, where }: `side` is the smooth part of the surface that contains the
 * triangle, and `where` the two parameters of the corner on that part.
 */
export function trianglesOf({ vertices, normals, uvs, faces }, { sides }) {
  return faces.map((face) => {
    const valuesIn = (list) => face.map((i) => list[i])
    const uvPairs = face.map((i) => [uvs[2 * i] ?? 0, uvs[2 * i + 1] ?? 0])
    const corner = (j) => ({ vertex: face[j], p: valuesIn(vertices)[j], n: valuesIn(normals)[j] })
    if (!sides) {
      const side = parametrizeTriangle(valuesIn(vertices), valuesIn(normals), uvPairs)
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
        const parameters = side.parametersOf(p, m.normalize(n), uvPairs[j])
        if (parameters) return { ...corner(j), side, where: parameters }
      }
      throw new Error(`no side has the normal ${n}`)
    })
  })
}

/** Returns the exact outward normal at a corner after `move`, or at a point nearby if the corner is at an edge of its side. */
function trueNormal({ side, where: [u, v], n }, move, turn) {
  const margin = side.edges ? 1e-6 : 0
  v = Math.min(1 - margin, Math.max(margin, v))
  const step = 1e-7
  const tangents = (place) => [
    m.subtract(place(u + step, v), place(u - step, v)),
    m.subtract(place(u, v + step), place(u, v - step)),
  ]
  const restNormal = m.cross(...tangents((s, t) => side.at(s, t).p))
  const movedNormal = m.cross(...tangents((s, t) => move(side.at(s, t))))
  return m.transformNormal(
    turn,
    m.normalize(m.dot(restNormal, n) < 0 ? movedNormal.map((x) => -x) : movedNormal),
  )
}

/**
 * Tests whether a corner is at a pole, an apex or the centre of a cap. There u has no derivative, so an offset that depends on u tears the
 * surface.
 */
export const isTorn = ({ side, where: [, v] }) =>
  side.edges?.some((edge) => Math.abs(v - edge) < 1e-9)

/**
 * Tests whether the normal at a torn corner depends on the direction of approach, so that it cannot be compared. It can be compared on p5's
 * own shapes of several sides: at the apex of a cone.
 */
const isAmbiguous = (corner, { isBuilt, sides }) =>
  isTorn(corner) && (isBuilt || sides.length === 1)

const toScreen = ([x, y, z]) => [x, y].map((k) => size / 2 + (distance * k) / (distance - z))

const interpolate = (weights, vectors) =>
  vectors[0].map((_, k) => vectors.reduce((sum, vector, i) => sum + weights[i] * vector[k], 0))

/** Returns for each pixel the index of the frontmost triangle, -1 if there is none. */
function findFrontmost(triangles) {
  const frontmost = new Int32Array(size * size).fill(-1)
  const nearest = new Float64Array(size * size)
  triangles.forEach((places, id) => {
    const [[ax, ay], [bx, by], [cx, cy]] = places.map(toScreen)
    const doubleArea = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    if (Math.abs(doubleArea) < 1e-9) return
    // These values are linear in screen space.
    const [nearA, nearB, nearC] = places.map(([, , z]) => 1 / (distance - z))
    const [left, right] = pixelsAcross(ax, bx, cx)
    const [top, bottom] = pixelsAcross(ay, by, cy)
    // Avoids arrays in the inner loop, which runs for 20 million pixels.
    for (let y = top; y < bottom; y++)
      for (let x = left; x < right; x++) {
        const [px, py] = [x + 0.5, y + 0.5]
        const a = ((cx - bx) * (py - by) - (cy - by) * (px - bx)) / doubleArea
        const b = ((ax - cx) * (py - cy) - (ay - cy) * (px - cx)) / doubleArea
        const c = ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / doubleArea
        if (a < 0 || b < 0 || c < 0) continue
        const near = a * nearA + b * nearB + c * nearC
        if (near <= nearest[y * size + x]) continue
        nearest[y * size + x] = near
        frontmost[y * size + x] = id
      }
  })
  return frontmost
}

const pixelsAcross = (...ends) => [
  Math.max(0, Math.floor(Math.min(...ends))),
  Math.min(size, Math.ceil(Math.max(...ends))),
]

/**
 * Finds the visible triangles in the picture of the shape, rotated by `aboutX` and `aboutY`. Returns a point near each of their corners,
 * with the normal that is interpolated from the exact normals of the triangle's corners. Leaves out triangles with an ambiguous corner, and
 * points
 * - around which pixels show anything but one smooth surface,
 * - where the normals change too much from pixel to pixel,
 * - whose normal has a component of at most 0.1, since the normal material shows only positive components.
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
      m.transformPoint(turn, move({ p, n, uv: side.at(...where).uv })),
    ),
  )
  const frontmost = findFrontmost(places)
  return triangles.flatMap((corners, id) => {
    const isSmooth = (x, y) => {
      const other = triangles[frontmost[y * size + x]]
      return other?.some(({ vertex }) => corners.some((corner) => corner.vertex === vertex))
    }
    if (corners.some((corner) => isAmbiguous(corner, shape))) return []
    return [0, 1, 2].flatMap((j) => {
      const weights = [0, 1, 2].map((i) => (i === j ? 0.8 : 0.1))
      const point = toScreen(interpolate(weights, places[id]))
      // The four pixels that `colorAt` interpolates.
      const [column, row] = point.map((x) => Math.floor(x - 0.5))
      for (const x of [0, 1])
        for (const y of [0, 1]) if (frontmost[(row + y) * size + column + x] !== id) return []
      for (const x of [-1, 0, 1, 2])
        for (const y of [-1, 0, 1, 2]) if (!isSmooth(column + x, row + y)) return []
      const normals = corners.map((corner) => trueNormal(corner, move, turn))
      // If neighbouring pixels differ much, as on triangles seen edge-on, the picture is too coarse to compare.
      const screen = places[id].map(toScreen)
      const maxChange = Math.max(
        ...[0, 1, 2].map((i) => {
          const next = (i + 1) % 3
          const step = Math.hypot(...m.subtract(normals[next], normals[i]))
          return step / Math.hypot(screen[next][0] - screen[i][0], screen[next][1] - screen[i][1])
        }),
      )
      if (maxChange > 0.04) return []
      const normal = m.normalize(interpolate(weights, normals))
      return Math.min(...normal) > 0.1 ? [{ normal, at: point, ...corners[j] }] : []
    })
  })
}
