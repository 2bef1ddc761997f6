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
import { fromAxis } from './parts.js'

export interface TaperOptions {
  /** The direction in which the shape becomes narrower. Default: `'y'`, which is down in p5. */
  axis?: AxisOption
  /** The point of the axis whose slice keeps its size, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The fraction of its size that a slice loses for each `length` along the axis. Default: 0.5. 0 moves nothing; negative
   * values make the shape wider. */
  amount?: NumberOption
  /** The length over which `amount` applies, in units above 0. Default: 200. */
  length?: NumberOption
}

/**
 * Scales each slice across an axis by r = max(0, 1 - amount · h / length), where h is the slice's coordinate along the axis, from `center`:
 * the global taper of Barr, "Global and Local Deformations of Solid Primitives" (1984), with a linear profile. Where r is 0 the shape
 * collapses to a line, which has no normals. Throws a `WarpError` for unknown options and wrong values.
 */
export const taper = (options?: TaperOptions): OffsetFunction =>
  deformer(
    'taper',
    options,
    { axis: axis('y'), center: vector(), amount: number(0.5), length: positive(200) },
    ({ position }, { axis, center, amount, length }) => {
      const { along, across } = fromAxis(position, center, axis)
      return across.mult(amount.div(length).mult(along).neg().max(-1))
    },
  )
