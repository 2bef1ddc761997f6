// `compileWarp` of 'warpjet/text', which only writes shader code.
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import { callback } from '../options/kinds.js'
import { Place } from '../options/place.js'
import { textsOf, type Emits } from './emit.js'
import { OffsetWarp } from './offset-warp.js'
import { readWarpOptions, type WarpOptions } from './warp-options.js'
import type { WarpText } from './warp-text.js'

const place = new Place('compileWarp')

/**
 * Compiles an offset function into statements that move a vertex and transform its normal, like `compileWarp` of 'warpjet' and
 * with the same options, except that `evaluate` and the other methods for the CPU throw a `WarpError`.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpText & Emits {
  callback.read(offset, place)
  const settings = readWarpOptions(options, place)
  const warp = new OffsetWarp(place, offset as OffsetFunction, settings)
  return { ...textsOf(warp, settings), ...unavailableMethods }
}

const unavailableMethods = Object.fromEntries(
  ['evaluate', 'evaluateAt', 'bounds', 'foldover'].map((method) => [
    method,
    () => {
      throw new Place(method).error(
        `this compileWarp only writes shader code; compileWarp of the script p5.warpjet.min.js, and of 'warpjet', also runs on the CPU.`,
      )
    },
  ]),
)
