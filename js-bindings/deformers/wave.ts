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
import { travelling } from './parts.js'

export interface WaveOptions {
  /** Where the wave travels to; `'x'` unless given. */
  axis?: AxisOption
  /** Where it moves points to, and back; `'y'` unless given. */
  direction?: AxisOption
  /** A point where the wave begins to rise when the sketch starts, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** How far points move to each side, in units; 20 unless given, and 0 moves nothing. */
  amount?: NumberOption
  /** From crest to crest, in units above 0; 100 unless given. */
  wavelength?: NumberOption
  /** In units a second; 100 unless given. A constant 0 stands still, and reads no time. */
  speed?: NumberOption
}

/**
 * A plane wave that travels along an axis: direction · amount · sin(2π (h - speed · t) / wavelength) at h along the axis
 * and t seconds after the sketch started. Throws a `WarpError` for unknown options and wrong values.
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
      return direction.mult(travelling(glsl, along, wavelength, speed, millis).sin().mult(amount))
    },
  )
