import type { OffsetFunction } from '../types.js'
import { type NumberOption, type VectorOption, number, vector } from './kinds.js'
import { deformer } from './options.js'

export interface InflateOptions {
  /** How far, in units; 20 unless given. 0 moves nothing, below 0 the shape gets thinner. */
  amount?: NumberOption
  /** Where to: any vector, whose length counts; the normal, made of length 1, unless given. */
  direction?: VectorOption
}

/**
 * Moves points by direction · amount, along their normals unless told otherwise. How the normal varies over the surface
 * is not known from it alone, and counts as nothing: with one amount for all points, the normals stay as they are, which
 * is exact; with one that varies, its own slope counts and that of the normal does not, an error in proportion to amount ·
 * curvature. Throws a `WarpError` for unknown options and wrong values.
 */
export const inflate = (options?: InflateOptions): OffsetFunction =>
  deformer(
    'inflate',
    options,
    { amount: number(20), direction: vector(({ normal }) => normal.normalize()) },
    (_, { amount, direction }) => direction.mult(amount),
  )
