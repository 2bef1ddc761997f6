import type { OffsetFunction } from '../core/types/types.js'
import { deformer } from './deformer.js'
import { number, vector, type NumberOption, type VectorOption } from './kinds.js'

export interface SpherifyOptions {
  /** The centre of the sphere, in units. Default: `[0, 0, 0]`. A point at the centre does not move. */
  center?: VectorOption
  /** The radius of the sphere, in units. Default: 100. */
  radius?: NumberOption
  /** From 0, the shape itself, to 1, the sphere, and beyond. Default: 1. */
  amount?: NumberOption
}

/**
 * Blends towards a sphere: p becomes mix(p, center + radius · d / |d|, amount), where d = p - center. On the sphere itself,
 * positions depend only on the direction from the centre, so points in the same direction collapse. Throws a `WarpError` for
 * unknown options and wrong values.
 */
export const spherify = (options?: SpherifyOptions): OffsetFunction =>
  deformer(
    'spherify',
    options,
    { center: vector(), radius: number(100), amount: number(1) },
    ({ position }, { center, radius, amount }) => {
      const away = position.sub(center)
      return away.normalize().mult(radius).sub(away).mult(amount)
    },
  )
