import type { OffsetFunction } from '../core/types/types.js'
import { type NumberOption, type VectorOption, number, vector } from './kinds.js'
import { deformer } from './deformer.js'

export interface SpherifyOptions {
  /** Of the sphere, in units; `[0, 0, 0]` unless given. A point that lies there stays. */
  center?: VectorOption
  /** Of the sphere, in units; 100 unless given. */
  radius?: NumberOption
  /** From 0, the shape itself, to 1, the sphere, and beyond; 1 unless given. */
  amount?: NumberOption
}

/**
 * Blends towards a sphere: p becomes mix(p, center + radius · d / |d|, amount), where d = p - center. On the sphere itself
 * points have their directions from the centre only, so that what lies along one of them collapses. Throws a `WarpError`
 * for unknown options and wrong values.
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
