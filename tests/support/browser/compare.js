// Measures the errors of warped vertices.
import { angleBetween, distanceBetween } from './oracle.js'

/** The default max error of a warp's normals, in degrees. */
export const maxDegrees = 0.02

/** Max sensitivity (see `warpVertex` in oracle.js) of compared normals. Above it the surface is almost collapsed, and float32 cannot
 * represent its direction. */
export const maxSensitivity = 1e5

export const moments = [0, 1234, 98765].map((millis) => ({
  millis,
  mouse: [120, 250],
  size: [640, 480],
  pixelDensity: 2,
}))

const vectorAt = (numbers, start) => [numbers[start], numbers[start + 1], numbers[start + 2]]

/** Returns the position and the normal of vertex i; `results` has 6 floats per vertex. */
export const positionAndNormal = (results, i) => [
  vectorAt(results, 6 * i),
  vectorAt(results, 6 * i + 3),
]

/**
 * Returns the max differences between `results` and `expected`. Both have a list per moment: `results` with six numbers per vertex,
 * `expected` with the results of `warpVertex`. Errors of positions are relative to the larger of the distance from the origin and
 * `reach`, the largest number in the offset's formula. For vertices with a kink nearby, checks only whether the result is finite. Also
 * returns the counts.
 */
export function compare(results, expected, reach, bound = maxDegrees) {
  const worst = { position: 0, angle: 0, relativeAngle: 0, length: 0 }
  const counts = {
    count: 0, // all vertices
    notFinite: 0,
    kinks: 0, // not compared: a kink nearby
    vanishing: 0, // expected normal is zero
    notZero: 0, // expected normal is zero, but the result has a normal
    collapsing: 0, // normal not compared: surface almost collapsed
    beyond: 0, // normals off by more than `bound` degrees
  }
  const raise = (name, value) => (worst[name] = Math.max(worst[name], value))
  expected.forEach((moment, k) =>
    moment.forEach(({ position, normal, sensitivity }, i) => {
      const [warpedPosition, warpedNormal] = positionAndNormal(results[k], i)
      counts.count++
      if (![...warpedPosition, ...warpedNormal].every(Number.isFinite)) return counts.notFinite++
      if (!normal) return counts.kinks++
      raise(
        'position',
        distanceBetween(warpedPosition, position) / Math.max(reach, Math.hypot(...position)),
      )
      if (warpedNormal.some(Boolean)) raise('length', Math.abs(Math.hypot(...warpedNormal) - 1))
      if (!normal.some(Boolean)) {
        counts.vanishing++
        if (warpedNormal.some(Boolean)) counts.notZero++
        return
      }
      if (sensitivity > maxSensitivity) return counts.collapsing++
      const angle = angleBetween(warpedNormal, normal)
      if (!(angle <= bound)) counts.beyond++
      raise('angle', angle)
      raise('relativeAngle', angle / sensitivity)
    }),
  )
  return { ...worst, ...counts }
}
