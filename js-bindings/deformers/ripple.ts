import type { OffsetFunction } from '../core/types/types.js'
import {
  type AxisOption,
  type NumberOption,
  type VectorOption,
  axis,
  number,
  positive,
  vector,
} from './kinds.js'
import { deformer } from './deformer.js'
import { falloff, fromAxis, travelling } from './parts.js'

export interface RippleOptions {
  /** Where it moves points to, and back: out of the surface of the water; `'z'` unless given. The rings lie around it. */
  axis?: AxisOption
  /** Where the rings come from, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** How far points move at the centre, to each side, in units; 20 unless given, and 0 moves nothing. */
  amount?: NumberOption
  /** From ring to ring, in units above 0; 50 unless given. */
  wavelength?: NumberOption
  /** In units a second, away from the centre; 50 unless given. A constant 0 stands still, and reads no time. */
  speed?: NumberOption
  /** How far the rings reach, in units above 0; they fade towards there; 200 unless given. */
  radius?: NumberOption
}

/**
 * Rings that travel away from a centre: axis · amount · w · sin(2π (r - speed · t) / wavelength), t seconds after the
 * sketch started. r = √(d² + (wavelength / 8)²) is the distance d from the axis, rounded so that the middle is no spike,
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
      const rings = travelling(glsl, distance, wavelength, speed, millis).sin()
      return axis.mult(rings.mult(amount, falloff(squared.div(radius.pow(2)))))
    },
  )
