// Expressions that several formulas share.
import type { Glsl, Scalar, Vec3 } from '../core/types/types.js'

/**
 * Decomposes a position relative to the line through `center` in the direction of the unit vector `axis`: into `along`, its coordinate
 * along the line, and `across`, the vector from the line to the position.
 */
export function fromAxis(position: Vec3, center: Vec3, axis: Vec3) {
  const fromCenter = position.sub(center)
  const along = fromCenter.dot(axis)
  return { along, across: fromCenter.sub(axis.mult(along)) }
}

/** Returns (1 - x²)³ from the square of x, clamped: 1 at 0, and 0 at 1 and beyond, with continuous first and second derivatives. */
export const falloff = (squared: Scalar): Scalar => squared.min(1).neg().add(1).pow(3)

/** Returns the phase, in radians, of a wave that travels `speed` units per second. */
export function wavePhase(
  glsl: Glsl,
  distance: Scalar,
  wavelength: Scalar,
  speed: Scalar,
  millis: Scalar,
): Scalar {
  const travelled = speed.div(1000).mult(millis)
  return distance.sub(travelled).mult(glsl.div(2 * Math.PI, wavelength))
}
