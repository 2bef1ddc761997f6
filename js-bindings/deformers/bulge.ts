import type { OffsetFunction } from '../core/types/types.js'
import { optional } from '../options/kinds.js'
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
import { falloff, fromAxis } from './parts.js'

export interface BulgeOptions {
  /** The centre of the bulge, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** If present, points move away from this axis, like those of a barrel; otherwise away from `center`, like those of a
   * ball. */
  axis?: AxisOption
  /** The fraction of their distance by which points move at the centre of the bulge. Default: 0.5. 0 moves nothing;
   * negative values make a dent. Space turns inside out below -1, and also above 1.5 without an axis, where the centre
   * overtakes its surroundings. */
  amount?: NumberOption
  /** The extent of the bulge, in units above 0: from `center`, or along the axis in both directions. Default: 100. */
  radius?: NumberOption
}

/**
 * Moves points away by d · amount · w, where d is the vector to them from the centre (or the axis) and
 * w = (1 - (r / radius)²)³ fades from 1 at the centre to 0 at `radius`, with continuous first and second derivatives; r is
 * the distance from the centre or, if there is an axis, the part of that distance along the axis. Throws a `WarpError` for unknown options
 * and wrong values.
 */
export const bulge = (options?: BulgeOptions): OffsetFunction =>
  deformer(
    'bulge',
    options,
    {
      center: vector(),
      axis: optional(axis()),
      amount: number(0.5),
      radius: positive(100),
    },
    ({ position }, { axis, center, amount, radius }) => {
      if (!axis) {
        const away = position.sub(center)
        return away.mult(amount.mult(falloff(away.dot(away).div(radius.pow(2)))))
      }
      const { along, across } = fromAxis(position, center, axis)
      return across.mult(amount.mult(falloff(along.div(radius).pow(2))))
    },
  )
