// Loads the front end for shader text. Nothing happens before the first source.
import inlined from '../generated/glsl-wasm.js'
import { startWithTexts } from './texts.js'

/** A source that was read: an address, to be closed. */
export type SourceHandle = number & { readonly source: unique symbol }

/** glsl.cpp. */
export interface GlslModule {
  openSource(text: string): SourceHandle
  _closeSource(source: SourceHandle): void
  sourceProblem(source: SourceHandle): string
  functionLines(source: SourceHandle): string
  _lower(source: SourceHandle, number: number, maxIterations: number): void
  _words(source: SourceHandle): number
  _wordCount(source: SourceHandle): number
  _constants(source: SourceHandle): number
  _constantCount(source: SourceHandle): number
  _results(source: SourceHandle): number
  _resultCount(source: SourceHandle): number
  nameLines(source: SourceHandle): string
  routineLines(source: SourceHandle): string
  codes(): string

  /** Whether it ran out of memory, and nothing of it may be used any more. */
  isBroken?: boolean

  readonly HEAPU32: Uint32Array
  readonly HEAPF64: Float64Array
}

const givesText = new Set(['sourceProblem', 'functionLines', 'nameLines', 'routineLines', 'codes'])

let module: GlslModule | undefined

export function getGlsl(): GlslModule {
  return (module ??= startWithTexts<GlslModule>(inlined, givesText, 'shader', () => {
    module = undefined
  }))
}
