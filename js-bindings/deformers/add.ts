import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { markLibraryFunction } from '../errors/operators.js'
import { Place } from '../options/place.js'
import { warpsOf } from './warps.js'

/**
 * Adds the offsets of several warps: each gets the original vertex, so their order does not matter. Throws a `WarpError`
 * if an argument is not a function and, when the warp is made, if a function does not return a vec3.
 */
export function add<Uniforms extends UniformValues = {}>(
  ...warps: OffsetFunction<Uniforms>[]
): OffsetFunction<Uniforms> {
  const all = warpsOf(new Place('add'), warps)
  return markLibraryFunction((inputs) =>
    all.map((offsetAt) => offsetAt(inputs)).reduce((sum, offset) => sum.add(offset)),
  )
}
