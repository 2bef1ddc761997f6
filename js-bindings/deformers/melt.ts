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

export interface MeltOptions {
  /** The direction in which the shape falls. Default: `'y'`, which is down in p5. */
  axis?: AxisOption
  /** A point of the vertical line from which the puddle spreads, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** From 0, unchanged, to 1, flat on the ground. Default: 0.5. */
  amount?: NumberOption
  /** The distance of the ground below `center`, in units along the axis. Default: 100. */
  ground?: NumberOption
  /** The fraction of its size by which the puddle grows when the shape has melted completely. Default: 1. */
  spread?: NumberOption
  /** The height above the ground in which the shape spreads, in units above 0. Default: 100. */
  height?: NumberOption
}

/**
 * Sinks a shape to the ground and spreads it there: a height u above the ground becomes u (1 - amount), and sizes
 * perpendicular to the axis grow by the factor 1 + spread · amount · exp(-(u / height)²). At amount 1 the shape is flat, and
 * only parts that faced up or down have normals. Throws a `WarpError` for unknown options and wrong values.
 */
export const melt = (options?: MeltOptions): OffsetFunction =>
  deformer(
    'melt',
    options,
    {
      axis: axis('y'),
      center: vector(),
      amount: number(0.5),
      ground: number(100),
      spread: number(1),
      height: positive(100),
    },
    ({ position }, { axis, center, amount, ground, spread, height }) => {
      const { along, across } = fromAxis(position, center, axis)
      const above = ground.sub(along)
      const widening = above.div(height).pow(2).neg().exp()
      return axis.mult(above.mult(amount)).add(across.mult(widening.mult(spread, amount)))
    },
  )
