import type { OffsetFunction } from '../core/types/types.js'
import {
  type AxisOption,
  type NumberOption,
  type VectorOption,
  axis,
  number,
  optional,
  positive,
  vector,
} from './kinds.js'
import { deformer } from './deformer.js'
import { falloff, fromAxis } from './parts.js'

export interface BulgeOptions {
  /** The middle of the bulge, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** If given, points move away from this axis, as of a barrel; otherwise away from `center`, as of a ball. */
  axis?: AxisOption
  /** By what part of their distance points move at the middle of the bulge; 0.5 unless given. 0 moves nothing, below 0
   * it is a dent. Below -1 space turns inside out, and so it does above 1.5 without an axis, where the middle overtakes
   * what lies around it. */
  amount?: NumberOption
  /** How far the bulge reaches, in units above 0: from `center`, or along the axis to both sides; 100 unless given. */
  radius?: NumberOption
}

/**
 * Moves points away by d · amount · w, where d leads to them from the centre (or the axis) and w = (1 - (r / radius)²)³
 * fades from 1 at the centre to 0 at `radius`, with continuous first and second derivatives; r is the distance from the
 * centre (or from it along the axis). Throws a `WarpError` for unknown options and wrong values.
 */
export const bulge = (options?: BulgeOptions): OffsetFunction =>
  deformer(
    'bulge',
    options,
    {
      center: vector(),
      axis: optional(axis('y')),
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
