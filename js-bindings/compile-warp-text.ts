// `compileWarp` for those who want its text alone.
import { type Emits, compileOffset } from './compile-offset.js'
import { WarpError } from './errors.js'
import { version } from './generated/version.js'
import type { OffsetFunction, UniformValues } from './types.js'
import type { WarpOptions, WarpText } from './warp-text.js'

/**
 * Compiles an offset function into statements that move a vertex and turn its normal: what `compileWarp` of 'warpjet' does,
 * with its options, but for `evaluate` and its companions, which throw a `WarpError` here.
 */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): WarpText & Emits {
  const { text, emit } = compileOffset(offset as OffsetFunction, options)
  return { ...text, emit, ...elsewhere }
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
