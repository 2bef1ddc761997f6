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

export interface MeltOptions {
  /** Where things fall; `'y'`, which is down in p5, unless given. */
  axis?: AxisOption
  /** A point of the upright line that the puddle spreads from, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** How much has melted: 0, nothing, to 1, flat on the ground; 0.5 unless given. */
  amount?: NumberOption
  /** How far the ground is below `center`, in units along the axis; 100 unless given. */
  ground?: NumberOption
  /** By what part of its size the puddle grows when all has melted; 1 unless given. */
  spread?: NumberOption
  /** How high above the ground things spread, in units above 0; 100 unless given. */
  height?: NumberOption
}

/**
 * Sinks to the ground and spreads there: a height u above the ground becomes u (1 - amount), and what is at right angles
 * to the axis grows by the factor 1 + spread · amount · exp(-(u / height)²). At amount 1 the shape is flat, and only what
 * faced up or down has normals. Throws a `WarpError` for unknown options and wrong values.
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
