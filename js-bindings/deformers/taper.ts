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
import { fromAxis } from './parts.js'

export interface TaperOptions {
  /** Where it gets narrower; `'y'`, which is down in p5, unless given. */
  axis?: AxisOption
  /** A point of the axis, the one whose slice keeps its size, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** What part of its size a slice loses for each `length` along the axis; 0.5 unless given. 0 moves nothing, below 0 it
   * gets wider. */
  amount?: NumberOption
  /** In units, above 0; 200 unless given. */
  length?: NumberOption
}

/**
 * Scales each slice across an axis, by r = max(0, 1 - amount · h / length) at h along it: the global taper of Barr,
 * "Global and Local Deformations of Solid Primitives" (1984), with a linear profile. Where r is 0 the shape ends in a
 * line, which has no normals. Throws a `WarpError` for unknown options and wrong values.
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
