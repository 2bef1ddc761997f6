// Pieces that several formulas share.
import type { Glsl, Scalar, Vec3 } from '../core/types/types.js'

/** A point as seen from `center`: how far it is along `axis`, of length 1, and the vector to it from that line. */
export function fromAxis(position: Vec3, center: Vec3, axis: Vec3) {
  const fromCenter = position.sub(center)
  const along = fromCenter.dot(axis)
  return { along, across: fromCenter.sub(axis.mult(along)) }
}

/** From 1 at 0 to 0 at 1 and beyond, (1 - x²)³ from the square of x: without a kink, and without one in its slope. */
export const falloff = (squared: Scalar): Scalar => squared.min(1).neg().add(1).pow(3)

/** The phase, in radians, of a wave that travels `speed` units a second. */
export function travelling(
  glsl: Glsl,
  distance: Scalar,
  wavelength: Scalar,
  speed: Scalar,
  millis: Scalar,
): Scalar {
  const travelled = speed.div(1000).mult(millis)
  return distance.sub(travelled).mult(glsl.div(2 * Math.PI, wavelength))
}
