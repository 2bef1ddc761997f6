import type { OffsetFunction } from '../core/types/types.js'
import {
  type AxisOption,
  type NumberOption,
  type VectorOption,
  axis,
  flag,
  number,
  vector,
} from './kinds.js'
import { deformer } from './deformer.js'
import { fromAxis } from './parts.js'

export interface StretchOptions {
  /** Along what; `'y'` unless given. */
  axis?: AxisOption
  /** The point that stays, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** What part of its length the shape grows by; 0.5 unless given. 0 moves nothing, 1 doubles the length, -0.5 halves
   * it. */
  amount?: NumberOption
  /** Whether it gets thinner as it gets longer, so that volumes stay; false unless given. The length is then at least a
   * hundredth of what it was. */
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
    { axis: axis('y'), center: vector(), amount: number(0.5), keepVolume: flag(false) },
    ({ position }, { axis, center, amount, keepVolume }) => {
      const { along, across } = fromAxis(position, center, axis)
      if (!keepVolume) return axis.mult(along.mult(amount))
      const scale = amount.add(1).max(0.01)
      const thinner = scale.inversesqrt().sub(1)
      return axis.mult(along.mult(scale.sub(1))).add(across.mult(thinner))
    },
  )
