/**
 * The single script for a <script> tag. Its exports are what the global `warpjet` holds. It may stand before or after
 * p5's own tag: p5 starts a sketch when the page has loaded, which is after DOMContentLoaded.
 */
import { gen } from './compile.js'
import type { CompiledWarp } from './compile-warp.js'
import type { CpuWarp } from './cpu-warp.js'
import { WarpError } from './errors.js'
import { version } from './generated/version.js'
import { checkTarget } from './kept-module.js'
import { noteApproximation } from './notes.js'
import { registerGlobally } from './p5.js'
import type { OffsetFunction, UniformValues } from './types.js'
import { type WarpOptions, declareUniforms, keepWarp, readOptions, writeWarp } from './warp-text.js'

export { compile, gen } from './compile.js'
export { WarpError } from './errors.js'
export { version } from './generated/version.js'

/** `compileWarp` without what runs on the CPU, which would make this script a quarter larger. */
export function compileWarp<const Uniforms extends UniformValues = {}>(
  offset: OffsetFunction<NoInfer<Uniforms>>,
  options: WarpOptions<Uniforms> = {},
): CompiledWarp {
  const settings = readOptions('compileWarp', offset as OffsetFunction, options)
  const given = declareUniforms('compileWarp', offset as OffsetFunction, options)
  const warp = keepWarp(given.offset, settings)
  if (warp.isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
  const emit: CompiledWarp['emit'] = (target, more) =>
    writeWarp(warp, checkTarget(target), more).text
  return { ...writeWarp(warp, settings.target).text, emit, ...onlyInThePackage }
}

const onlyInThePackage = Object.fromEntries(
  ['evaluate', 'evaluateAt', 'bounds', 'foldover'].map((method) => [
    method,
    () => {
      throw new WarpError(
        `${method}: this script leaves out what runs on the CPU; take compileWarp from the package: const { compileWarp } = await import('https://cdn.jsdelivr.net/npm/warpjet@${version}/dist/warpjet.js').`,
      )
    },
  ]),
) as unknown as CpuWarp

if (!registerGlobally() && typeof document !== 'undefined')
  document.addEventListener('DOMContentLoaded', registerGlobally)

// glsl-autodiff's global, so that sketches written for it run unchanged.
const globals = globalThis as { AutoDiff?: unknown }
globals.AutoDiff ??= { gen }
