// `compileWarp`: compiles an offset function to shader code and for the CPU.
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { callback } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { textsOf, type Emits } from './emit.js'
import { HostWarp } from './host-warp.js'
import { readWarpOptions, type WarpOptions } from './warp-options.js'
import type { WarpText } from './warp-text.js'

/** The key of a warp's `HostWarp`. It is the same in all scripts of a page. */
export const hostWarp = Symbol.for('warpjet.host')

/** An offset function as shader code and on the CPU. */
export interface CompiledWarp extends WarpText, Emits, CpuWarp {
  /** @internal */
  readonly [hostWarp]: HostWarp
}

const place = new Place('compileWarp')

/**
 * Compiles an offset function into statements that move a vertex and transform its normal. They declare
 * `vec3 offset, warpedPosition, warpedNormal`. The normal has length 1, or 0 where the warp collapses the surface, and points
 * outwards even if the warp mirrors all of space. With `tangents: true` they also declare `vec4 warpedTangent`: its xyz has length
 * 1 and is perpendicular to the warped normal; its w is that of the input tangent, negated if the warp mirrors all of space.
 *
 * The warped normal ignores how the offset depends on `color`, which is treated as constant over the surface. So are `normal` and `uv`,
 * unless the option `surfaceVariation` is set. `evaluate` and the other methods evaluate the same warp on the CPU.
 *
 * Throws a `WarpError` if the offset is not a function, does not return a vec3, or misuses an operation, and for wrong options.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): CompiledWarp {
  callback.read(offset, place)
  const settings = readWarpOptions(options, place)
  const warp = new HostWarp(place, offset as OffsetFunction, settings)
  return { ...textsOf(warp, settings), ...warp.cpu(), [hostWarp]: warp }
}
