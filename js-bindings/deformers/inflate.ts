import type { OffsetFunction } from '../core/types/types.js'
import { type NumberOption, type VectorOption, number, vector } from './kinds.js'
import { deformer } from './deformer.js'

export interface InflateOptions {
  /** How far, in units; 20 unless given. 0 moves nothing, below 0 the shape gets thinner. */
  amount?: NumberOption
  /** Where to: any vector, whose length counts; the normal, made of length 1, unless given. */
  direction?: VectorOption
}

/**
 * Moves points by direction · amount, along their normals unless told otherwise. How the normal varies over the surface
 * counts where the mesh says it: `addSurfaceVariation(shape)` in p5, `surfaceVariation` of 'warpjet/mesh'. Otherwise it
 * counts as constant, which is right where all points move by one amount; where the amount varies, its own slope still
 * counts, and the error is in proportion to amount · curvature. Throws a `WarpError` for unknown options and wrong values.
 */
export const inflate = (options?: InflateOptions): OffsetFunction =>
  deformer(
    'inflate',
    options,
    { amount: number(20), direction: vector(({ normal }) => normal.normalize()) },
    (_, { amount, direction }) => direction.mult(amount),
  )
