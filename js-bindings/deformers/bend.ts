import { WarpError } from '../errors/errors.js'
import type { OffsetFunction, Scalar } from '../core/types/types.js'
import {
  type AxisOption,
  type NumberOption,
  type VectorOption,
  axis,
  constantDirection,
  number,
  vector,
} from './kinds.js'
import { checkDeformerOptions, deformer } from './deformer.js'

export interface BendOptions {
  /** What it is bent about; `'z'` unless given. */
  axis?: AxisOption
  /** The direction that is bent, straight before; `'y'` unless given, or `'x'` if the axis is the y axis. Only its part
   * at right angles to the axis counts. */
  along?: AxisOption
  /** A point of the line that keeps its length, and one that stays where `from` and `to` are on both sides of it, in
   * units; `[0, 0, 0]` unless given. */
  center?: VectorOption
  /** In radians, between the two straight ends; π/2 unless given, and 0 moves nothing. Seen from where the axis points
   * to, what lies ahead turns counterclockwise. */
  angle?: NumberOption
  /** Where the bend begins and ends, in units along the line, measured from `center`; -100 and 100 unless given. `to`
   * must be above `from`. */
  from?: NumberOption
  to?: NumberOption
}

/**
 * Bends a straight line into an arc, which goes on straight at both ends: the global linear bend of Barr, "Global and
 * Local Deformations of Solid Primitives" (1984). With k = angle / (to - from) and s' = clamp(s, from, to) for s along the
 * line, slices turn by θ = k s' about the centre of the arc, at 1 / k from the line. Space beyond that centre turns inside
 * out. Throws a `WarpError` for unknown options and wrong values.
 */
export function bend(options?: BendOptions): OffsetFunction {
  checkDeformerOptions('bend', options, kinds)
  const given: BendOptions = { ...options }
  const about = constantDirection(given.axis ?? 'z')
  given.along ??= about?.[1] && Math.abs(about[1]) === 1 ? 'x' : 'y'
  checkDirections(about, constantDirection(given.along))
  checkRange(given)
  return deformer('bend', given, kinds, (inputs, values) => {
    const { axis, center, angle, from, to } = values
    const fromCenter = inputs.position.sub(center)
    const line = values.along.sub(axis.mult(values.along.dot(axis))).normalize()
    const side = axis.cross(line)

    const [s, height] = [fromCenter.dot(line), fromCenter.dot(side)]
    const onArc = s.clamp(from, to)
    const beyond = s.sub(onArc)
    const turn = angle.div(to.sub(from).max(1e-6)).mult(onArc)
    const [sin, cos] = [turn.sin(), turn.cos()]

    // The end of the arc: s' sin θ / θ and s' (1 - cos θ) / θ, in which no radius becomes infinite.
    const isSmall = turn.mult(turn).lt(0.1)
    // 1 / θ where it is used, and finite everywhere, which `bounds` needs.
    const inverse = turn.div(turn.mult(turn).max(0.1))
    const ahead = onArc.mult(isSmall.ifElse(sineSeries(turn), sin.mult(inverse)))
    const aside = onArc.mult(isSmall.ifElse(versineSeries(turn), cos.neg().add(1).mult(inverse)))
    const moved = ahead.add(beyond.mult(cos)).sub(height.mult(sin))
    const lifted = aside.add(beyond.mult(sin)).add(height.mult(cos))
    return line.mult(moved.sub(s)).add(side.mult(lifted.sub(height)))
  })
}

const kinds = {
  axis: axis('z'),
  along: axis('y'),
  center: vector(),
  angle: number(Math.PI / 2),
  from: number(-100),
  to: number(100),
}

/** 1 - x² / a (1 - x² / b (1 - …)) */
const nested = (x: Scalar, [divisor, ...others]: number[]): Scalar =>
  divisor === undefined ? x.pow(0) : nested(x, others).mult(x.pow(2)).div(divisor).neg().add(1)

/** sin x / x and (1 - cos x) / x up to x⁸ and x⁹; for x² < 0.1 what is left out is below 3e-13. */
const sineSeries = (x: Scalar) => nested(x, [2 * 3, 4 * 5, 6 * 7, 8 * 9])
const versineSeries = (x: Scalar) =>
  nested(x, [3 * 4, 5 * 6, 7 * 8, 9 * 10])
    .mult(x)
    .div(2)

function checkDirections(axis?: number[], along?: number[]) {
  if (!axis || !along) return
  const cosine = axis.reduce((sum, x, i) => sum + x * along[i]!, 0)
  if (Math.abs(cosine) > 1 - 1e-9)
    throw new WarpError(
      'bend: the options "axis" and "along" have the same direction; bend about an axis at right angles to the line.',
    )
}

function checkRange({ from = -100, to = 100 }: BendOptions) {
  if (typeof from === 'number' && typeof to === 'number' && !(from < to))
    throw new WarpError(`bend: the option "to" must be above "from", but is ${to} beside ${from}.`)
}
