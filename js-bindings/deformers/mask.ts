import { asOwn } from '../errors/operators.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { type NumberOption, number } from './kinds.js'
import { reader } from './deformer.js'
import { checkWarps, offsetOf } from './warps.js'

/**
 * A part of a warp: its offset times `weight`, from 0 for nothing to 1 for all. A weight that varies over the shape, such
 * as `({ glsl, position }) => glsl.smoothstep(100, 50, position.length())`, makes a warp local, and its slope counts for
 * the normals. Throws a `WarpError` for what is no function, for wrong weights and none, and, when the warp is made, if it
 * returns no vec3.
 */
export function mask<Uniforms extends UniformValues = {}>(
  warp: OffsetFunction<Uniforms>,
  weight: NumberOption,
): OffsetFunction<Uniforms> {
  checkWarps('mask', [warp])
  const readWeight = reader('mask: the weight', { ...number(1), standard: undefined }, weight)
  return asOwn((inputs) => offsetOf('mask', 1, warp, inputs).mult(readWeight(inputs)))
}
