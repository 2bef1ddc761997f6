import type { OffsetFunction } from '../core/types/types.js'
import { optional } from '../options/kinds.js'
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

export interface GenieOptions {
  /** The point that the shape vanishes into, in units. Default: `[0, 200, 0]`, which is below the shape in p5. */
  center?: VectorOption
  /** The direction in which the shape is pulled. Default: `'y'`. Parts beyond `center` are only narrowed. */
  axis?: AxisOption
  /** From 0, unchanged, to 1, vanished. Default: 0.5. */
  amount?: NumberOption
  /** The distance from `center` to the end of the shape, in units above 0. Default: 300. Parts further away are not pulled
   * in completely. */
  length?: NumberOption
  /** The fraction of its width that the shape has at `center`. Default: 0, a point. */
  neck?: NumberOption
  /** If present, the shape keeps its width along this axis, and vanishes into an edge. */
  edge?: AxisOption
}

/**
 * Pulls a shape into a point or an edge, like windows into the Dock of macOS: it first narrows into a funnel and then
 * slides down it. With u the distance before `center` along the axis, u' = u - min(max(u, 0), length · m), and widths are
 * scaled by mix(1, mix(neck, 1, smoothstep(0, length, u')), k), where k = smoothstep(0, 0.6, amount) and
 * m = smoothstep(0.3, 1, amount). Parts that have arrived are collapsed, and have no normals. Throws a `WarpError` for
 * unknown options and wrong values.
 */
export const genie = (options?: GenieOptions): OffsetFunction =>
  deformer(
    'genie',
    options,
    {
      center: vector([0, 200, 0]),
      axis: axis('y'),
      amount: number(0.5),
      length: positive(300),
      neck: number(0),
      edge: optional(axis()),
    },
    ({ glsl, position }, { axis, center, amount, length, neck, edge }) => {
      const { along, across } = fromAxis(position, center, axis)
      const before = along.neg()
      const [narrow, slide] = [glsl.smoothstep(0, 0.6, amount), glsl.smoothstep(0.3, 1, amount)]
      const fall = before.max(0).min(length.mult(slide))
      const funnel = neck.mix(1, glsl.smoothstep(0, length, before.sub(fall)))
      const narrowed = edge ? across.sub(edge.mult(across.dot(edge))) : across
      return axis.mult(fall).add(narrowed.mult(funnel.sub(1).mult(narrow)))
    },
  )
