// Measures the errors of warped vertices.
import { angleBetween, distanceBetween } from './oracle.js'

/** The default bound of a warp's errors of normals, in degrees. */
export const maxDegrees = 0.02

/** Above this sensitivity a surface is almost collapsed, and float32 cannot represent its direction. */
export const maxSensitivity = 1e5

export const moments = [0, 1234, 98765].map((millis) => ({
  millis,
  mouse: [120, 250],
  size: [640, 480],
  pixelDensity: 2,
}))

const vectorAt = (numbers, start) => [numbers[start], numbers[start + 1], numbers[start + 2]]

/** Returns position and normal of vertex i, which has six numbers. */
export const positionAndNormal = (results, i) => [
  vectorAt(results, 6 * i),
  vectorAt(results, 6 * i + 3),
]

/**
 * Returns the max differences between `results` and `expected`. Both have a list per moment: `results` with six numbers per vertex,
 * `expected` with the results of `warpVertex`. Errors of positions are relative to `reach`, the size of the numbers in the formula. For
 * vertices with a kink nearby, checks only whether the result is finite. `beyond` counts the normals that are more than `bound` degrees
 * off. Of the other counts, `kinks` and `collapsing` are vertices whose normals are not compared; `vanishing` are those where the moved
 * surface has no normal, and `notZero` those of them where the result has one.
 */
export function compare(results, expected, reach, bound = maxDegrees) {
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
