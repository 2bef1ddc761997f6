import type { OffsetFunction } from '../core/types/types.js'
import { deformer } from './deformer.js'
import {
  axis,
  number,
  vector,
  type AxisOption,
  type NumberOption,
  type VectorOption,
} from './kinds.js'

export interface ShearOptions {
  /** The axis along which the displacement grows. Default: `'y'`. */
  axis?: AxisOption
  /** The direction in which points move. Default: `'x'`. */
  direction?: AxisOption
  /** A point of the slice that does not move, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The displacement per unit along the axis, which is the tangent of the angle. Default: 0.5; 0 moves nothing. */
  amount?: NumberOption
}

/**
 * Moves points by direction · amount · h, where h is the coordinate along the axis, from `center`. Throws a `WarpError` for unknown options
 * and wrong values.
 */
export const shear = (options?: ShearOptions): OffsetFunction =>
  deformer(
    'shear',
    options,
    { axis: axis('y'), direction: axis('x'), center: vector(), amount: number(0.5) },
    ({ position }, { axis, direction, center, amount }) =>
      direction.mult(position.sub(center).dot(axis).mult(amount)),
  )
