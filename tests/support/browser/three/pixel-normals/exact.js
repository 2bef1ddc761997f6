// Computes exact normals of a warped surface at pixels: finite differences, in double, of the positions to which the offset moves an
// interpolated vertex. Uses no derivatives of the library.
import { compile } from 'warpjet'
import { add, cross, dot, normalize } from '../../matrix.js'

const scale = (v, factor) => v.map((x) => x * factor)

/** If two estimates of a derivative differ by more than this, a kink is nearby. */
const maxRoughness = 1e-4
const h = 2e-5

/** Returns a function of position, normal and uv that returns the moved position. */
export function makeMover(offset) {
  const compiled = compile((glsl) => ({
    offset: offset({
      glsl,
      position: glsl.vec3Param('p'),
      normal: glsl.vec3Param('n'),
      uv: glsl.vec2Param('t'),
    }),
  }))
  return (p, n, t) => add(p, compiled.evaluate({ p, n, t }).offset)
}

/**
 * Returns the unit normal and, if the vertex has a tangent, the warped tangent, which is not normalized; null near a kink. `gradients` are
 * those of the normal's components and of u and v, in the order of the attributes.
 */
export function exactVertex(move, { position, normal, uv, gradients, tangent }) {
  const n = normalize(normal)
  const smallest = n.map(Math.abs).indexOf(Math.min(...n.map(Math.abs)))
  const first = normalize(
    cross(
      [0, 1, 2].map((k) => Number(k === smallest)),
      n,
    ),
  )
  const derivative = (direction) => {
    const slopes = gradients.map((gradient) => dot(gradient, direction))
    const moveBy = (step) =>
      move(
        add(position, scale(direction, step)),
        add(normal, scale(slopes.slice(0, 3), step)),
        uv.map((x, k) => x + step * slopes[3 + k]),
      )
    const slope = (step) => {
      const [after, before] = [moveBy(step), moveBy(-step)]
      return after.map((x, k) => (x - before[k]) / (2 * step))
    }
    const [coarse, fine] = [slope(h), slope(h / 2)]
    const isSmooth = coarse.every((x, k) => Math.abs(x - fine[k]) < maxRoughness)
    return isSmooth ? fine.map((x, k) => (4 * x - coarse[k]) / 3) : null
  }
  const [u, v] = [first, cross(n, first)].map(derivative)
  const warpedTangent = tangent && derivative(tangent.slice(0, 3))
  if (!u || !v || warpedTangent === null) return null
  const warpedNormal = normalize(cross(u, v))
  // Keeps the tangent perpendicular to the normal.
  return {
    normal: warpedNormal,
    tangent:
      warpedTangent && add(warpedTangent, scale(warpedNormal, -dot(warpedTangent, warpedNormal))),
  }
}

export const degreesBetween = (a, b) =>
  (Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) * 180) / Math.PI

/** Returns the value below which this share of the numbers is. */
export const quantile = (numbers, share) =>
  [...numbers].sort((a, b) => a - b)[
    Math.min(numbers.length - 1, Math.floor(share * numbers.length))
  ]
