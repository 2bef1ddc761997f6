import { asOwn } from '../errors/operators.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { inputsAt } from './places.js'
import { checkWarps, offsetOf } from './warps.js'

/**
 * One warp after the other: the second acts on what the first moved, and so on. It is given the moved position, and as
 * `normal` the unit normal that the surface has by then, zero where the warps before have collapsed it; all other inputs
 * are those of the vertex. The normal is turned by the exact derivative of all that came before, so that
 * `chain(twist(), inflate())` inflates the twisted shape; where those before read `normal`, `uv` or `color`, these count as
 * constant in it.
 *
 * A moved position is no input, so that nothing can be derived by it: `glsl.derivative(x, position.x())` throws a
 * `WarpError` in all warps but the first.
 *
 * Throws a `WarpError` for what is no function, and, when the warp is made, if one returns no vec3.
 */
export function chain<Uniforms extends UniformValues = {}>(
  ...warps: OffsetFunction<Uniforms>[]
): OffsetFunction<Uniforms> {
  checkWarps('chain', warps)
  return asOwn((inputs) => {
    let offset = offsetOf('chain', 1, warps[0]!, inputs)
    for (const [i, warp] of warps.entries())
      if (i > 0) {
        const moved = inputsAt(inputs, inputs.position.add(offset))
        offset = offset.add(offsetOf('chain', i + 1, warp, moved))
      }
    return offset
  })
}
