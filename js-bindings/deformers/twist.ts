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

export interface TwistOptions {
  /** What is turned about; `'y'` unless given. */
  axis?: AxisOption
  /** A point of the axis, the one whose slice stays as it is, in units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** In radians, by how much the slices that are `length` apart are turned against each other; π/2 unless given, and 0
   * moves nothing. Seen from where the axis points to, what lies ahead turns counterclockwise. */
  angle?: NumberOption
  /** In units, above 0; 200 unless given. */
  length?: NumberOption
}

/**
 * Turns each slice about an axis, the further the further it is along: the global axial twist of Barr, "Global and Local
 * Deformations of Solid Primitives" (1984), by the angle θ = angle · h / length at h along the axis. It goes on beyond
 * `length`, and keeps volumes. Throws a `WarpError` for unknown options and wrong values.
 */
export const twist = (options?: TwistOptions): OffsetFunction =>
  deformer(
    'twist',
    options,
    { axis: axis('y'), center: vector(), angle: number(Math.PI / 2), length: positive(200) },
    ({ position }, { axis, center, angle, length }) => {
      const { along, across } = fromAxis(position, center, axis)
      const turn = angle.div(length).mult(along)
      // Rodrigues' formula, for what is at right angles to the axis.
      return across.mult(turn.cos().sub(1)).add(axis.cross(across).mult(turn.sin()))
    },
  )
