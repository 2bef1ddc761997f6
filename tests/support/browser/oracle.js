// The expected result of a warp, in double precision and independent of our compiler. The offset is a plain function of numbers. Normals
// are computed from the tangents of the moved surface, and these from finite differences of the offset.
import { add, cross, dot, normalize, subtract } from './matrix.js'

const length = (v) => Math.hypot(...v)

/** If two estimates of a derivative differ by more than this, a kink or a jump is nearby. */
const maxRoughness = 1e-5

const axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
]
/** This direction finds kinks that x, y and z miss, such as the jump of sign(x) y at the origin. */
const oblique = [1, -1.1, 1.2]

/**
 * Returns the derivative of `f` at `p` along a direction, from steps h, h/2 and h/4; null if `f` is not smooth within h. `middle`
 * is f(p).
 */
function differentiateAlong(f, p, direction, h, middle) {
  const [x, y, z] = direction
  const at = (step) => f([p[0] + step * x, p[1] + step * y, p[2] + step * z])
  const [after1, before1] = [at(h), at(-h)]
  const [after2, before2] = [at(h / 2), at(-h / 2)]
  const [after4, before4] = [at(h / 4), at(-h / 4)]
  const slopes = []
  for (let i = 0; i < 3; i++) {
    // Central differences are f' + a h² + b h⁴ + …; Richardson's extrapolation eliminates a, and then b.
    const d1 = (after1[i] - before1[i]) / (2 * h)
    const d2 = (after2[i] - before2[i]) / h
    const d4 = (after4[i] - before4[i]) / (h / 2)
    const coarse = (4 * d2 - d1) / 3
    const fine = (4 * d4 - d2) / 3
    // Second differences are h f'' + O(h³). Only these show a kink at p itself.
    const bend1 = (after1[i] - 2 * middle[i] + before1[i]) / h
    const bend2 = (after2[i] - 2 * middle[i] + before2[i]) / (h / 2)
    const isSmooth =
      Math.abs(coarse - fine) <= maxRoughness && Math.abs(bend1 - 2 * bend2) <= maxRoughness
    if (!isSmooth) return null
    slopes.push((16 * fine - coarse) / 15)
  }
  return slopes
}

/** Returns the partial derivatives of `f` with respect to x, y and z, each a vector; null if `f` is not smooth within `h` of `p`. */
export function jacobian(f, p, h) {
  const middle = f(p)
  const columns = [...axes, oblique].map((direction) =>
    differentiateAlong(f, p, direction, h, middle),
  )
  return columns.includes(null) ? null : columns.slice(0, 3)
}

/** Returns vectors u, v with u × v = n, where n has length 1. */
function tangents(n) {
  const u = normalize(
    cross(
      axes.find((axis) => Math.abs(dot(axis, n)) < 0.6),
      n,
    ),
  )
  return [u, cross(n, u)]
}

/** If the moved tangents span less than this area (originally 1), it is a rounding error of the differences. */
const minArea = 1e-10

/**
 * Returns the vertex after the warp → { position, normal, sensitivity }. `normal` is null if the function is not smooth within
 * `h`, and zero if the moved surface has none. `sensitivity`, 1 for a warp that moves nothing, is the factor by which an error of
 * the derivatives grows in the normal: it is large if the surface is almost collapsed. `mirrors` returns, from the
 * inputs, whether the warp mirrors space: if so, the outward normal is opposite to the cross product of the moved tangents.
 */
export function warpVertex(offset, vertex, inputs, h, mirrors) {
  const all = { ...inputs, ...vertex }
  const move = (p) => add(p, offset(p, all))
  const position = move(vertex.position)
  const withoutNormal = { position, normal: [0, 0, 0], sensitivity: 1 }
  if (!vertex.normal.some(Boolean)) return withoutNormal

  const columns = jacobian(move, vertex.position, h)
  if (!columns) return { position, normal: null }
  const [u, v] = tangents(normalize(vertex.normal)).map((tangent) =>
    axes.map((_, row) =>
      dot(
        [0, 1, 2].map((column) => columns[column][row]),
        tangent,
      ),
    ),
  )
  const normal = mirrors?.(all) ? cross(v, u) : cross(u, v)
  const size = Math.max(1, ...columns.map(length))
  if (length(normal) < minArea * size ** 2) return withoutNormal
  return { position, normal: normalize(normal), sensitivity: size ** 2 / length(normal) }
}

/** Returns the angle in degrees; accurate even for small angles. */
export const angleBetween = (a, b) => (Math.atan2(length(cross(a, b)), dot(a, b)) * 180) / Math.PI

export const distanceBetween = (a, b) => length(subtract(a, b))
