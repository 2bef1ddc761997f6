// The shader code of `compileWarp`, and its frame constants.
import { type Uniforms, checkUniforms } from '../core/inputs/vertices.js'
import { type Target, targetKind } from '../core/module/serialized-module.js'
import { noteApproximation } from '../errors/notes.js'
import { Place } from '../options/place.js'
import type { OffsetWarp } from './offset-warp.js'
import type { Result } from './recorded-warp.js'
import { type RecordOptions, type TextOptions, textOptions } from './warp-options.js'
import type { WarpText } from './warp-text.js'

/** The methods of a compiled warp that write more code and compute frame constants. */
export interface Emits {
  /**
   * Writes the same warp in another language, or with other names. The offset function is not called again, so that it is the
   * same warp even if the function uses random numbers. Default: the names of the options of `compileWarp`.
   */
  emit(target: Target, options?: TextOptions): WarpText
  /**
   * With the option `perFrame`: returns values for the vec4s `warpjetFrame0`, … among `uniforms`, to be set each frame. `inputs` are
   * those that are constant during a frame, such as `{ millis: performance.now() }`, and values that replace those of the option
   * `uniforms`. Throws a `WarpError` for a missing or wrong value.
   */
  frameUniforms(inputs?: Uniforms): Record<string, number[]>
}

const emitPlace = new Place('emit')
const framePlace = new Place('frameUniforms')

export function textsOf(warp: OffsetWarp, options: RecordOptions): WarpText & Emits {
  const { target, normals, tangents } = options
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
  const text = write(target!)
  if (warp.isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
  return {
    ...text,
    emit: (target, names) =>
      write(
        targetKind.read(target, emitPlace.part('the target')),
        textOptions.read(names, emitPlace),
      ),
    frameUniforms(given = {}) {
      checkUniforms(framePlace, given, warp.variableNames())
      const constants = Object.entries(warp.frame(given, framePlace))
      // Copies, which the caller may change.
      return Object.fromEntries(constants.map(([name, values]) => [name, [...values]]))
    },
  }
}
