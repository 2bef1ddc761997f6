import type { OffsetFunction } from '../core/types/types.js'
import { boolean } from '../options/kinds.js'
import { deformer } from './deformer.js'
import {
  axis,
  number,
  vector,
  type AxisOption,
  type NumberOption,
  type VectorOption,
} from './kinds.js'
import { fromAxis } from './parts.js'

export interface StretchOptions {
  /** The axis along which the shape is stretched. Default: `'y'`. */
  axis?: AxisOption
  /** The point that does not move, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The fraction of its length by which the shape grows. Default: 0.5. 0 moves nothing, 1 doubles the length, -0.5
   * halves it. */
  amount?: NumberOption
  /** If true, the shape becomes thinner as it becomes longer, such that volumes are preserved. Default: false. The length
   * is then at least a hundredth of the original. */
  keepVolume?: boolean
}

/**
 * Scales along an axis by s = 1 + amount, and with `keepVolume` across it by 1 / √s: the global scaling of Barr, "Global
 * and Local Deformations of Solid Primitives" (1984), whose determinant s · (1 / √s)² is 1. Throws a `WarpError` for
 * unknown options and wrong values.
 */
export const stretch = (options?: StretchOptions): OffsetFunction =>
  deformer(
    'stretch',
    options,
    { axis: axis('y'), center: vector(), amount: number(0.5), keepVolume: boolean(false) },
    ({ position }, { axis, center, amount, keepVolume }) => {
      const { along, across } = fromAxis(position, center, axis)
      if (!keepVolume) return axis.mult(along.mult(amount))
      const scale = amount.add(1).max(0.01)
      const thinner = scale.inversesqrt().sub(1)
      return axis.mult(along.mult(scale.sub(1))).add(across.mult(thinner))
    },
  )
