import { asOwn } from '../errors/operators.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { Place } from '../options/place.js'
import { warpsOf } from './warps.js'

/**
 * The sum of the offsets: each warp is given the vertex as it is, so that their order makes no difference. Throws a
 * `WarpError` for what is no function, and, when the warp is made, if one returns no vec3.
 */
export function add<Uniforms extends UniformValues = {}>(
  ...warps: OffsetFunction<Uniforms>[]
): OffsetFunction<Uniforms> {
  const all = warpsOf(new Place('add'), warps)
  return asOwn((inputs) =>
    all.map((offsetAt) => offsetAt(inputs)).reduce((sum, offset) => sum.add(offset)),
  )
}
