import { asOwn } from '../errors/operators.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { type NumberOption, number } from './kinds.js'
import { Place } from '../options/place.js'
import { warpsOf } from './warps.js'

/**
 * From one warp to another: each is given the vertex as it is, and points move on the straight line between where the two
 * move them. `amount` is 0 for the first, 1 for the second, and 0.5 unless given; if it varies over the shape, its slope
 * counts for the normals. Throws a `WarpError` for what is no function, for wrong amounts, and, when the warp is made, if
 * one returns no vec3.
 */
export function blend<Uniforms extends UniformValues = {}>(
  from: OffsetFunction<Uniforms>,
  to: OffsetFunction<Uniforms>,
  amount?: NumberOption,
): OffsetFunction<Uniforms> {
  const place = new Place('blend')
  const [first, second] = warpsOf(place, [from, to])
  const amountAt = number(0.5).read(amount, place.part('the amount'))
  return asOwn((inputs) => first!(inputs).mix(second!(inputs), amountAt(inputs)))
}
