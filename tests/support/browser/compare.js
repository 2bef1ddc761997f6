// Measures the errors of warped vertices.
import { angleBetween, distanceBetween } from './oracle.js'

/** The max error of a normal, unless its warp says otherwise. */
export const degrees = 0.02

/** Above this sensitivity a surface is almost collapsed, and float32 cannot represent its direction. */
export const maxSensitivity = 1e5

export const moments = [0, 1234, 98765].map((millis) => ({
  millis,
  mouse: [120, 250],
  size: [640, 480],
  pixelDensity: 2,
}))

const three = (numbers, at) => [numbers[at], numbers[at + 1], numbers[at + 2]]

/** Offsets of position and normal among the six numbers of a vertex. */
export const parts = (results, i) => [three(results, 6 * i), three(results, 6 * i + 3)]

/**
 * Returns the max differences of `results`, for each time six numbers per vertex, from `expected`, for each time and vertex the
 * result of `warpVertex`. For vertices with a kink nearby, checks only whether the result is finite. `beyond` counts the normals
 * that are more than `bound` degrees off.
 */
export function compare(results, expected, reach, bound = degrees) {
  const worst = { position: 0, angle: 0, relativeAngle: 0, length: 0 }
  const counts = {
    count: 0,
    kinks: 0,
    collapsing: 0,
    vanishing: 0,
    notFinite: 0,
    notZero: 0,
    beyond: 0,
  }
  const raise = (name, value) => (worst[name] = Math.max(worst[name], value))
  expected.forEach((moment, k) =>
    moment.forEach(({ position, normal, sensitivity }, i) => {
      const [moved, turned] = parts(results[k], i)
      counts.count++
      if (![...moved, ...turned].every(Number.isFinite)) return counts.notFinite++
      if (!normal) return counts.kinks++
      raise('position', distanceBetween(moved, position) / Math.max(reach, Math.hypot(...position)))
      if (turned.some(Boolean)) raise('length', Math.abs(Math.hypot(...turned) - 1))
      if (!normal.some(Boolean)) {
        counts.vanishing++
        if (turned.some(Boolean)) counts.notZero++
        return
      }
      if (sensitivity > maxSensitivity) return counts.collapsing++
      const angle = angleBetween(turned, normal)
      if (!(angle <= bound)) counts.beyond++
      raise('angle', angle)
      raise('relativeAngle', angle / sensitivity)
    }),
  )
  return { ...worst, ...counts }
}
