import type { OffsetFunction } from '../core/types/types.js'
import { deformer } from './deformer.js'
import {
  axis,
  number,
  positive,
  vector,
  type AxisOption,
  type NumberOption,
  type VectorOption,
} from './kinds.js'
import { falloff, fromAxis, wavePhase } from './parts.js'

export interface RippleOptions {
  /** The direction in which points move, perpendicular to the surface of the water. Default: `'z'`. It is also the axis of
   * the rings. */
  axis?: AxisOption
  /** The centre of the rings, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The distance that points at the centre move in both directions, in units. Default: 20; 0 moves nothing. */
  amount?: NumberOption
  /** The distance between rings, in units above 0. Default: 50. */
  wavelength?: NumberOption
  /** The speed away from the centre, in units per second. Default: 50. A constant 0 does not read the time. */
  speed?: NumberOption
  /** The radius at which the rings have faded out, in units above 0. Default: 200. */
  radius?: NumberOption
}

/**
 * Makes rings that travel away from a centre: axis · amount · w · sin(2π (r - speed · t) / wavelength), t seconds after the
 * sketch started. r = √(d² + (wavelength / 8)²) is the distance d from the axis, smoothed to avoid a spike at the centre,
 * and w = (1 - (d / radius)²)³ fades to 0 at `radius`. Throws a `WarpError` for unknown options and wrong values.
 */
export const ripple = (options?: RippleOptions): OffsetFunction =>
  deformer(
    'ripple',
    options,
    {
      axis: axis('z'),
      center: vector(),
      amount: number(20),
      wavelength: positive(50),
      speed: number(50),
      radius: positive(200),
    },
    ({ glsl, position, millis }, { axis, center, amount, wavelength, speed, radius }) => {
      const { across } = fromAxis(position, center, axis)
      const squared = across.dot(across)
      const distance = squared.add(wavelength.div(8).pow(2)).sqrt()
      const rings = wavePhase(glsl, distance, wavelength, speed, millis).sin()
      return axis.mult(rings.mult(amount, falloff(squared.div(radius.pow(2)))))
    },
  )
