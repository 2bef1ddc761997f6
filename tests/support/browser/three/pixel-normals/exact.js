// The exact normals of a warped surface at pixels: differences, in double, of where the offset moves the interpolated vertex. The
// derivatives of the library have no part in it.
import { compile } from 'warpjet'
import { add, cross, dot, normalize } from '../../matrix.js'

const scale = (v, factor) => v.map((x) => x * factor)

/** Estimates of one derivative that differ by more than this are due to a kink nearby. */
const roughness = 1e-4
const h = 2e-5

/** Returns a function of position, normal and uv to where the offset moves them. */
export function mover(offset) {
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
 * Returns the normal, and the tangent if there is one, not normalized; null near a kink. `gradients` are those of the components of the
 * normal and of u and v, in the order of the attributes.
 */
export function exactVertex(move, { position, normal, uv, gradients, tangent }) {
  const n = normalize(normal)
  const least = n.map(Math.abs).indexOf(Math.min(...n.map(Math.abs)))
  const first = normalize(
    cross(
      [0, 1, 2].map((k) => Number(k === least)),
      n,
    ),
  )
  const derivative = (direction) => {
    const along = gradients.map((gradient) => dot(gradient, direction))
    const at = (step) =>
      move(
        add(position, scale(direction, step)),
        add(normal, scale(along.slice(0, 3), step)),
        uv.map((x, k) => x + step * along[3 + k]),
      )
    const slope = (step) => {
      const [after, before] = [at(step), at(-step)]
      return after.map((x, k) => (x - before[k]) / (2 * step))
    }
    const [coarse, fine] = [slope(h), slope(h / 2)]
    const isSmooth = coarse.every((x, k) => Math.abs(x - fine[k]) < roughness)
    return isSmooth ? fine.map((x, k) => (4 * x - coarse[k]) / 3) : null
  }
  const [u, v] = [first, cross(n, first)].map(derivative)
  const along = tangent && derivative(tangent.slice(0, 3))
  if (!u || !v || along === null) return null
  const warped = normalize(cross(u, v))
  // A tangent stays at a right angle to the normal.
  return { normal: warped, tangent: along && add(along, scale(warped, -dot(along, warped))) }
}

export const degreesBetween = (a, b) =>
  (Math.atan2(Math.hypot(...cross(a, b)), dot(a, b)) * 180) / Math.PI

/** Returns the value below which a share of the numbers is. */
export const quantile = (numbers, share) =>
  [...numbers].sort((a, b) => a - b)[
    Math.min(numbers.length - 1, Math.floor(share * numbers.length))
  ]
