import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { markLibraryFunction } from '../errors/operators.js'
import { Place } from '../options/place.js'
import { number, type NumberOption } from './kinds.js'
import { warpsOf } from './warps.js'

/**
 * Scales the offset of a warp by `weight`, from 0 for no effect to 1 for the full effect. A weight that varies over the
 * shape, such as `({ glsl, position }) => glsl.smoothstep(100, 50, position.length())`, makes a warp local, and normals
 * account for its slope. Throws a `WarpError` if `warp` is not a function, for wrong or missing weights and, when the mask
 * is made, if `warp` does not return a vec3.
 */
export function mask<Uniforms extends UniformValues = {}>(
  warp: OffsetFunction<Uniforms>,
  weight: NumberOption,
): OffsetFunction<Uniforms> {
  const place = new Place('mask')
  const [offsetAt] = warpsOf(place, [warp])
  const weightAt = number().read(weight, place.part('the weight'))
  return markLibraryFunction((inputs) => offsetAt!(inputs).mult(weightAt(inputs)))
}
