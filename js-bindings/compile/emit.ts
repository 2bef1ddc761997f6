// The texts of `compileWarp`, and its frame constants.
import { type Uniforms, checkUniforms } from '../core/inputs/vertices.js'
import { type Target, checkTarget } from '../core/module/kept-module.js'
import { noteApproximation } from '../errors/notes.js'
import { checkOptions } from '../options/options.js'
import type { OffsetWarp } from './offset-warp.js'
import type { Result } from './recorded-warp.js'
import { type TextOptions, type WarpOptions, checkNames } from './warp-options.js'
import type { WarpText } from './warp-text.js'

/** The methods of a compiled warp that make further texts and frame constants. */
export interface Emits {
  /**
   * The text once more: in another language, or for a host with other names. The offset function is not called again, so
   * that it is the same warp, also if it was made by chance. What is not given is as in the options of `compileWarp`.
   */
  emit(target: Target, options?: TextOptions): WarpText
  /**
   * With the option `perFrame`: values for the vec4s `warpjetFrame0`, … among `uniforms`, to be set each frame. It takes the inputs
   * that are the same for a frame, such as `{ millis: performance.now() }`, and values in the place of those that the option `uniforms` gave.
   * Throws a `WarpError` for a value that is missing or wrong.
   */
  frameUniforms(inputs?: Uniforms): Record<string, number[]>
}

export function textsOf(warp: OffsetWarp, options: WarpOptions): WarpText & Emits {
  const { normals = true, tangents = false } = options
  const results: Result[] = [
    'offset',
    'position',
    ...(normals ? (['normal'] as const) : []),
    ...(tangents ? (['tangent'] as const) : []),
  ]
  const write = (target: Target, names?: TextOptions): WarpText => {
    const { parameters: _, frame: __, ...text } = warp.text(target, results, names)
    return text
  }
  const text = write(checkTarget(options.target))
  if (warp.isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
  return {
    ...text,
    emit(target, names = {}) {
      checkOptions('emit', names, ['names', 'outputs'])
      checkNames('emit', names)
      return write(checkTarget(target), names)
    },
    frameUniforms(given = {}) {
      checkUniforms('frameUniforms', given, warp.variableNames())
      // A copy of the caller's own.
      return Object.fromEntries(
        Object.entries(warp.frame(given, 'frameUniforms')).map(([name, values]) => [
          name,
          [...values],
        ]),
      )
    },
  }
}
