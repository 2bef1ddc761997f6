import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { markLibraryFunction } from '../errors/operators.js'
import { Place } from '../options/place.js'
import { number, type NumberOption } from './kinds.js'
import { warpsOf } from './warps.js'

/**
 * Blends two warps: each gets the original vertex, and points move on the straight line between the two results. `amount`
 * is 0 for the first and 1 for the second. Default: 0.5. If it varies over the shape, normals account for its slope. Throws
 * a `WarpError` if a warp is not a function, for wrong amounts and, when the blend is made, if a warp does not return a vec3.
 */
export function blend<Uniforms extends UniformValues = {}>(
  from: OffsetFunction<Uniforms>,
  to: OffsetFunction<Uniforms>,
  amount?: NumberOption,
): OffsetFunction<Uniforms> {
  const place = new Place('blend')
  const [first, second] = warpsOf(place, [from, to])
  const amountAt = number(0.5).read(amount, place.part('the amount'))
  return markLibraryFunction((inputs) => first!(inputs).mix(second!(inputs), amountAt(inputs)))
}
