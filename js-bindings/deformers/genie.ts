import type { OffsetFunction } from '../core/types/types.js'
import {
  type AxisOption,
  type NumberOption,
  type VectorOption,
  axis,
  number,
  optional,
  positive,
  vector,
} from './kinds.js'
import { deformer } from './deformer.js'
import { fromAxis } from './parts.js'

export interface GenieOptions {
  /** The point that the shape vanishes into, in units; `[0, 200, 0]` unless given, below the shape in p5. */
  center?: VectorOption
  /** The direction in which it is drawn there; `'y'` unless given. What lies beyond `center` is only narrowed. */
  axis?: AxisOption
  /** 0, all there, to 1, gone; 0.5 unless given. */
  amount?: NumberOption
  /** How far from `center` the shape ends, in units above 0; 300 unless given. What is further is not quite drawn in. */
  length?: NumberOption
  /** What part of its width the shape still has at `center`; 0 unless given, a point. */
  neck?: NumberOption
  /** If given, the shape keeps its width along this axis, and vanishes into an edge. */
  edge?: AxisOption
}

/**
 * Draws a shape into a point or an edge, as windows go into the Dock of macOS: it first narrows into a funnel and then
 * slides down it. With u the distance before `center` along the axis, u' = u - min(max(u, 0), length · m), and widths are
 * scaled by mix(1, mix(neck, 1, smoothstep(0, length, u')), k), where k = smoothstep(0, 0.6, amount) and
 * m = smoothstep(0.3, 1, amount). What has arrived has collapsed, and has no normals. Throws a `WarpError` for unknown
 * options and wrong values.
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
      edge: optional(axis('x')),
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
