// `compileWarp`: from an offset function to a warp, as shader text and on the CPU.
import type { CpuWarp } from '../cpu/cpu-warp.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { type Emits, textsOf } from './emit.js'
import { HostWarp } from './host-warp.js'
import { type WarpOptions, checkWarpOptions } from './warp-options.js'
import type { WarpText } from './warp-text.js'

/** An offset function as shader text and on the CPU. */
export interface CompiledWarp extends WarpText, Emits, CpuWarp {}

/**
 * Compiles an offset function into statements that move a vertex and turn its normal. They declare
 * `vec3 offset, warpedPosition, warpedNormal`; the normal has length 1, or 0 where the warp
 * collapses the surface, and points outwards even if the warp mirrors all of space. With `tangents: true` they also declare
 * `vec4 warpedTangent`: its xyz has length 1 and is at right angles to the warped normal; its w is that of the input tangent, or
 * its negative if the warp mirrors all of space. `color` counts
 * as constant over the surface, and so do `normal` and `uv` in the text without the option
 * `surfaceVariation`: where the offset depends on them, their share of the turn is left out then. The same warp runs on the CPU by `evaluate` and its companions. Throws a
 * `WarpError` if the offset is no function, returns no vec3, or misuses an operation, and for wrong
 * options.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): CompiledWarp {
  checkWarpOptions('compileWarp', offset, options)
  const warp = new HostWarp('compileWarp', offset as OffsetFunction, options)
  return { ...textsOf(warp, options), ...warp.cpu() }
}
