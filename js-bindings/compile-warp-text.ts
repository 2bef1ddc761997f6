// `compileWarp` for those who want its text alone.
import { WarpError } from './errors.js'
import { version } from './generated/version.js'
import type { OffsetFunction, UniformValues } from './types.js'
import { type WarpOptions, type WarpText, compileWarpText, noteIfApproximate } from './warp-text.js'

/**
 * Compiles an offset function into statements that move a vertex and turn its normal: what `compileWarp` of 'warpjet' does,
 * with its options, but for `evaluate` and its companions, which throw a `WarpError` here.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpText {
  const warp = compileWarpText('compileWarp', offset as OffsetFunction, options)
  noteIfApproximate(warp)
  return { ...warp.text, ...elsewhere }
}

const elsewhere = Object.fromEntries(
  ['evaluate', 'evaluateAt', 'bounds', 'foldover'].map((method) => [
    method,
    () => {
      throw new WarpError(
        `${method}: this compileWarp makes text only; take the one that also runs on the CPU, from 'warpjet' or, in a page, by: const { compileWarp } = await import('https://cdn.jsdelivr.net/npm/warpjet@${version}/dist/warpjet.min.js').`,
      )
    },
  ]),
)
