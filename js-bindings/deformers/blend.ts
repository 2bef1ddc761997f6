import { asOwn } from '../errors/operators.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { type NumberOption, number } from './kinds.js'
import { reader } from './deformer.js'
import { checkWarps, offsetOf } from './warps.js'

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
  checkWarps('blend', [from, to])
  const readAmount = reader('blend: the amount', number(0.5), amount)
  return asOwn((inputs) =>
    offsetOf('blend', 1, from, inputs).mix(offsetOf('blend', 2, to, inputs), readAmount(inputs)),
  )
}
