import { asOwn } from '../errors/operators.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { checkWarps, offsetOf } from './warps.js'

/**
 * The sum of the offsets: each warp is given the vertex as it is, so that their order makes no difference. Throws a
 * `WarpError` for what is no function, and, when the warp is made, if one returns no vec3.
 */
export function add<Uniforms extends UniformValues = {}>(
  ...warps: OffsetFunction<Uniforms>[]
): OffsetFunction<Uniforms> {
  checkWarps('add', warps)
  return asOwn((inputs) =>
    warps
      .map((warp, i) => offsetOf('add', i + 1, warp, inputs))
      .reduce((sum, offset) => sum.add(offset)),
  )
}
