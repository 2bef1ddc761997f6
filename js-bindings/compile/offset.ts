// What both kinds of `compileWarp` do: the offset function is called, and texts are written of what is kept of it.
import { type Target, checkTarget } from '../module/kept-module.js'
import { noteApproximation } from '../checks/notes.js'
import { checkOptions } from '../checks/options.js'
import type { OffsetFunction } from '../types/types.js'
import {
  type TextOptions,
  type WarpOptions,
  type WarpText,
  checkNames,
  declareUniforms,
  keepWarp,
  readOptions,
  writeWarp,
} from './warp-text.js'

export function compileOffset(given: OffsetFunction, options: WarpOptions) {
  const settings = readOptions('compileWarp', given, options)
  const { offset, declared } = declareUniforms('compileWarp', given, options)
  const warp = keepWarp(offset, settings)
  const { text } = writeWarp(warp, settings.target)
  if (warp.isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
  const emit = (target: Target, more: TextOptions = {}): WarpText => {
    checkOptions('emit', more, ['names', 'outputs'])
    checkNames('emit', more)
    return writeWarp(warp, checkTarget(target), more).text
  }
  return { warp, declared, text, emit }
}

/** What a compiled warp has beside its text. */
export interface Emits {
  /**
   * The text once more: in another language, or for a host with other names. The offset function is not called again, so
   * that it is the same warp, also if it was made by chance. What is not given is as in the options of `compileWarp`.
   */
  emit(target: Target, options?: TextOptions): WarpText
}
