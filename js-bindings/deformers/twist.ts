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

export interface TwistOptions {
  /** The axis of the twist. Default: `'y'`. */
  axis?: AxisOption
  /** The point of the axis whose slice does not move, in units. Default: `[0, 0, 0]`. */
  center?: VectorOption
  /** The angle between slices that are `length` apart, in radians. Default: π/2; 0 moves nothing. When the axis
   * points at the viewer, slices further along it turn counterclockwise. */
  angle?: NumberOption
  /** The length over which `angle` applies, in units above 0. Default: 200. */
  length?: NumberOption
}

/**
 * Rotates each slice about an axis by an angle θ = angle · h / length, where h is the slice's coordinate along the axis, from `center`: the
 * global axial twist of Barr, "Global and Local Deformations of Solid Primitives" (1984). The twist continues beyond `length`, and
 * preserves volumes. Throws a `WarpError` for unknown options and wrong values.
 */
export const twist = (options?: TwistOptions): OffsetFunction =>
  deformer(
    'twist',
    options,
    { axis: axis('y'), center: vector(), angle: number(Math.PI / 2), length: positive(200) },
    ({ position }, { axis, center, angle, length }) => {
      const { along, across } = fromAxis(position, center, axis)
      const turn = angle.div(length).mult(along)
      // Rodrigues' formula, for the component perpendicular to the axis.
      return across.mult(turn.cos().sub(1)).add(axis.cross(across).mult(turn.sin()))
    },
  )
