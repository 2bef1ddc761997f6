import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { markLibraryFunction } from '../errors/operators.js'
import { Place } from '../options/place.js'
import { inputsAt } from './places.js'
import { warpsOf } from './warps.js'

/**
 * Applies one warp after another: the second acts on the result of the first, and so on. Each gets the moved position, and as
 * `normal` the unit normal of the moved surface, zero where the previous warps have collapsed it; all other inputs
 * are those of the vertex. The normal is transformed by the exact derivative of all previous warps, so
 * `chain(twist(), inflate())` inflates the twisted shape; if previous warps read `normal`, `uv` or `color`, these are treated as
 * constant in that derivative.
 *
 * A moved position is not an input, so you cannot differentiate with respect to it: `glsl.derivative(x, position.x())` throws a
 * `WarpError` in all warps except the first.
 *
 * Throws a `WarpError` if an argument is not a function and, when the warp is made, if a function does not return a vec3.
 */
export function chain<Uniforms extends UniformValues = {}>(
  ...warps: OffsetFunction<Uniforms>[]
): OffsetFunction<Uniforms> {
  const [first, ...others] = warpsOf(new Place('chain'), warps)
  return markLibraryFunction((inputs) =>
    others.reduce(
      (offset, offsetAt) => offset.add(offsetAt(inputsAt(inputs, inputs.position.add(offset)))),
      first!(inputs),
    ),
  )
}
