import type { OffsetFunction } from '../core/types/types.js'
import {
  type AxisOption,
  type NumberOption,
  type VectorOption,
  axis,
  number,
  vector,
} from './kinds.js'
import { deformer } from './deformer.js'

export interface ShearOptions {
  /** Along which points move the further the further they are; `'y'` unless given. */
  axis?: AxisOption
  /** Where they move to; `'x'` unless given. */
  direction?: AxisOption
  /** A point of the slice that stays, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** By how many units points move for each unit along the axis, the tangent of an angle; 0.5 unless given, and 0 moves
   * nothing. */
  amount?: NumberOption
}

/**
 * Moves points by direction · amount · h at h along an axis. Throws a `WarpError` for unknown options and wrong values.
 */
export const shear = (options?: ShearOptions): OffsetFunction =>
  deformer(
    'shear',
    options,
    { axis: axis('y'), direction: axis('x'), center: vector(), amount: number(0.5) },
    ({ position }, { axis, direction, center, amount }) =>
      direction.mult(position.sub(center).dot(axis).mult(amount)),
  )
