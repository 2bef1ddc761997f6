import type { OffsetFunction } from '../core/types/types.js'
import { deformer } from './deformer.js'
import { number, positive, seed, vector, type NumberOption, type VectorOption } from './kinds.js'

export interface NoiseDisplaceOptions {
  /** The max distance that points move in both directions, in units. Default: 20; 0 moves nothing. */
  amount?: NumberOption
  /** The approximate size of the bumps, in units above 0. Default: 50. */
  scale?: NumberOption
  /** Any vector, whose length counts. Default: the unit normal. */
  direction?: VectorOption
  /** The point of the shape where the noise has its origin, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The number of times per second that the bumps change. Default: 0. A constant 0 does not read the time. */
  speed?: NumberOption
  /** A constant whole number; different seeds give different bumps. Default: 0. */
  seed?: number
}

/**
 * Moves points by direction · amount · noise(d / scale, speed · t) with `glsl.noise`, where d is the vector to them from
 * the centre and t the time in seconds since the sketch started. Normals account for how the normal varies in the same way
 * as for `inflate`. Throws a `WarpError` for unknown options and wrong values.
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
      seed: seed(0),
    },
    ({ glsl, position, millis }, { amount, scale, direction, center, speed, seed }) => {
      const place = position.sub(center).div(scale)
      const isStill = options?.speed === undefined || options.speed === 0
      const when = speed.div(1000).mult(millis)
      const noise = glsl.noise(isStill ? place : glsl.vec4(place, when), { seed })
      return direction.mult(noise.mult(amount))
    },
  )
