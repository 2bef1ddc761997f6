import type { OffsetFunction } from '../core/types/types.js'
import { deformer } from './deformer.js'
import { number, vector, type NumberOption, type VectorOption } from './kinds.js'

export interface InflateOptions {
  /** The distance, in units. Default: 20. 0 moves nothing; negative values make the shape thinner. */
  amount?: NumberOption
  /** Any vector, whose length counts. Default: the unit normal. */
  direction?: VectorOption
}

/**
 * Moves points by direction · amount, along their normals by default. The new normals account for how the normal varies
 * over the surface if the mesh has this information: by `addSurfaceVariation(shape)` in p5, or by `surfaceVariation` of
 * 'warpjet/mesh'. Otherwise the normal is treated as constant, which is exact if all points move by the same amount. If the
 * amount varies, normals still account for its slope, and their error is proportional to amount · curvature. Throws a `WarpError`
 * for unknown options and wrong values.
 */
export const inflate = (options?: InflateOptions): OffsetFunction =>
  deformer(
    'inflate',
    options,
    { amount: number(20), direction: vector(({ normal }) => normal.normalize()) },
    (_, { amount, direction }) => direction.mult(amount),
  )
