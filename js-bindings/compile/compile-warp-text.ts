// `compileWarp` for those who want its text alone.
import { type Emits, compileOffset } from './offset.js'
import { WarpError } from '../errors/errors.js'
import type { OffsetFunction, UniformValues } from '../core/types/types.js'
import type { WarpOptions, WarpText } from './warp-text.js'

/**
 * Compiles an offset function into statements that move a vertex and turn its normal: what `compileWarp` of 'warpjet' does,
 * with its options, but for `evaluate` and its companions, which throw a `WarpError` here.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpText & Emits {
  const { text, emits } = compileOffset(offset as OffsetFunction, options)
  return { ...text, ...emits, ...elsewhere }
}

/** As compile-warp.ts has it. */
export const runOnCpu = undefined

const elsewhere = Object.fromEntries(
  ['evaluate', 'evaluateAt', 'bounds', 'foldover'].map((method) => [
    method,
    () => {
      throw new WarpError(
        `${method}: this compileWarp makes text only; the one that also runs on the CPU is that of the script p5.warpjet.min.js, and of 'warpjet'.`,
      )
    },
  ]),
)
