import type { OffsetFunction, Scalar } from '../core/types/types.js'
import { optional } from '../options/kinds.js'
import { Place } from '../options/place.js'
import type { KindsOf } from '../options/schema.js'
import { readOptions, withFormula } from './deformer.js'
import {
  axis,
  constantDirection,
  number,
  vector,
  type AxisOption,
  type NumberOption,
  type VectorOption,
} from './kinds.js'

export interface BendOptions {
  /** The axis of the bend. Default: `'z'`. */
  axis?: AxisOption
  /** The direction of the line that is bent. Default: `'y'`, or `'x'` if the axis is the y axis. Only its component
   * perpendicular to the axis counts. */
  along?: AxisOption
  /** A point of the line whose length the bend keeps, in units. Default: `[0, 0, 0]`. The point does not move if it is
   * between `from` and `to`. */
  center?: VectorOption
  /** The angle between the two straight ends, in radians. Default: π/2; 0 moves nothing. When the axis points at the
   * viewer, the end at `to` turns counterclockwise. */
  angle?: NumberOption
  /** The start and end of the bend, in units along the line, measured from `center`. Default: -100 and 100. `to` must be
   * greater than `from`. */
  from?: NumberOption
  to?: NumberOption
}

/**
 * Bends a straight line into an arc that continues straight at both ends: the global linear bend of Barr, "Global and
 * Local Deformations of Solid Primitives" (1984). With k = angle / (to - from) and s' = clamp(s, from, to) for s along the
 * line, slices turn by θ = k s' about the centre of the arc, at 1 / k from the line. Space beyond that centre turns inside
 * out. Throws a `WarpError` for unknown options and wrong values.
 */
export function bend(options?: BendOptions): OffsetFunction {
  const computed = readOptions('bend', options, kinds)
  const { axis: about = 'z', from, to, along } = options ?? {}
  const isAboutY = Math.abs(constantDirection(about)?.[1] ?? 0) === 1
  const line = along ?? (isAboutY ? 'x' : 'y')
  rejectParallel(constantDirection(about), constantDirection(line))
  rejectEmptyRange(from, to)
  const values = { ...computed, along: computed.along ?? axis().read(line, place) }
  return withFormula(values, (inputs, values) => {
    const { axis, center, angle, from, to } = values
    const fromCenter = inputs.position.sub(center)
    const line = values.along.sub(axis.mult(values.along.dot(axis))).normalize()
    const side = axis.cross(line)

    const [s, height] = [fromCenter.dot(line), fromCenter.dot(side)]
    const onArc = s.clamp(from, to)
    const beyond = s.sub(onArc)
    const turn = angle.div(to.sub(from).max(1e-6)).mult(onArc)
    const [sin, cos] = [turn.sin(), turn.cos()]

    // The end of the arc: s' sin θ / θ and s' (1 - cos θ) / θ, which avoid an infinite radius.
    const isSmall = turn.mult(turn).lt(0.1)
    // 1 / θ for large θ, the only ones for which it is used. For small θ it is finite, since `bounds` also evaluates it there.
    const inverse = turn.div(turn.mult(turn).max(0.1))
    const ahead = onArc.mult(isSmall.ifElse(sineSeries(turn), sin.mult(inverse)))
    const aside = onArc.mult(isSmall.ifElse(versineSeries(turn), cos.neg().add(1).mult(inverse)))
    const moved = ahead.add(beyond.mult(cos)).sub(height.mult(sin))
    const lifted = aside.add(beyond.mult(sin)).add(height.mult(cos))
    return line.mult(moved.sub(s)).add(side.mult(lifted.sub(height)))
  })
}

const place = new Place('bend')

const kinds = {
  axis: axis('z'),
  along: optional(axis()),
  center: vector(),
  angle: number(Math.PI / 2),
  from: number(-100),
  to: number(100),
} satisfies KindsOf<BendOptions>

/** Returns 1 - x² / a (1 - x² / b (1 - …)). */
const nestedSeries = (x: Scalar, [divisor, ...others]: number[]): Scalar =>
  divisor === undefined
    ? x.pow(0)
    : nestedSeries(x, others).mult(x.pow(2)).div(divisor).neg().add(1)

/** Series of sin x / x and (1 - cos x) / x up to x⁸ and x⁹; for x² < 0.1 the remainder is below 3e-13. */
const sineSeries = (x: Scalar) => nestedSeries(x, [2 * 3, 4 * 5, 6 * 7, 8 * 9])
const versineSeries = (x: Scalar) =>
  nestedSeries(x, [3 * 4, 5 * 6, 7 * 8, 9 * 10])
    .mult(x)
    .div(2)

function rejectParallel(axis?: number[], along?: number[]) {
  if (!axis || !along) return
  const cosine = axis.reduce((sum, x, i) => sum + x * along[i]!, 0)
  if (Math.abs(cosine) > 1 - 1e-9)
    throw place.error(
      'the options "axis" and "along" have the same direction; bend about an axis perpendicular to the line.',
    )
}

function rejectEmptyRange(from: unknown = -100, to: unknown = 100) {
  if (typeof from === 'number' && typeof to === 'number' && !(from < to))
    throw place.option('to').expected(`a number above "from", which is ${from},`, `${to}`)
}
