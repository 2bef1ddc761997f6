import type { OffsetFunction } from '../core/types/types.js'
import { type NumberOption, type VectorOption, number, positive, vector, whole } from './kinds.js'
import { deformer } from './deformer.js'

export interface NoiseDisplaceOptions {
  /** How far points move at most, to each side, in units; 20 unless given, and 0 moves nothing. */
  amount?: NumberOption
  /** About how large the bumps are, in units above 0; 50 unless given. */
  scale?: NumberOption
  /** Where to: any vector, whose length counts; the normal, made of length 1, unless given. */
  direction?: VectorOption
  /** The point of the shape where the noise has its origin, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** How many times a second the bumps become others; 0 unless given. A constant 0 stands still, and reads no time. */
  speed?: NumberOption
  /** Another whole number gives other bumps; a constant, 0 unless given. */
  seed?: number
}

/**
 * Moves points by direction · amount · noise(d / scale, speed · t) with `glsl.noise`, where d leads to them from the centre
 * and t is in seconds after the sketch started. How the normal varies counts as for `inflate`. Throws a `WarpError` for
 * unknown options and wrong values.
 */
export const noiseDisplace = (options?: NoiseDisplaceOptions): OffsetFunction =>
  deformer(
    'noiseDisplace',
    options,
    {
      amount: number(20),
      scale: positive(50),
      direction: vector(({ normal }) => normal.normalize()),
      center: vector(),
      speed: number(0),
      seed: whole(0),
    },
    ({ glsl, position, millis }, { amount, scale, direction, center, speed, seed }) => {
      const place = position.sub(center).div(scale)
      const stands = options?.speed === undefined || options.speed === 0
      const when = speed.div(1000).mult(millis)
      const noise = glsl.noise(stands ? place : glsl.vec4(place, when), { seed })
      return direction.mult(noise.mult(amount))
    },
  )
