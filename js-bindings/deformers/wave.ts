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
import { wavePhase } from './parts.js'

export interface WaveOptions {
  /** The direction in which the wave travels. Default: `'x'`. */
  axis?: AxisOption
  /** The direction in which points move. Default: `'y'`. */
  direction?: AxisOption
  /** A point where the wave begins to rise when the sketch starts, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The distance that points move in both directions, in units. Default: 20; 0 moves nothing. */
  amount?: NumberOption
  /** The distance between crests, in units above 0. Default: 100. */
  wavelength?: NumberOption
  /** The speed in units per second. Default: 100. A constant 0 does not read the time. */
  speed?: NumberOption
}

/**
 * Makes a plane wave that travels along an axis: direction · amount · sin(2π (h - speed · t) / wavelength), where h is the coordinate
 * along the axis, from `center`, and t the time in seconds since the sketch started. Throws a `WarpError` for unknown options and wrong
 * values.
 */
export const wave = (options?: WaveOptions): OffsetFunction =>
  deformer(
    'wave',
    options,
    {
      axis: axis('x'),
      direction: axis('y'),
      center: vector(),
      amount: number(20),
      wavelength: positive(100),
      speed: number(100),
    },
    ({ glsl, position, millis }, { axis, direction, center, amount, wavelength, speed }) => {
      const along = position.sub(center).dot(axis)
      return direction.mult(wavePhase(glsl, along, wavelength, speed, millis).sin().mult(amount))
    },
  )
