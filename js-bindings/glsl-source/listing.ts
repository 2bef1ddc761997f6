// Lowers a function of GLSL or WGSL source to a plain list of operations, once. The list is independent of any session and of wasm memory.
import type { Place } from '../options/place.js'
import * as wasm from '../wasm/glsl.js'
import type { SourceLanguage } from './options.js'

export type FunctionHead = wasm.FunctionHead

/** A uniform or an attribute of the source. */
export type External = wasm.HostName

/** A name with its type. The type is written as in GLSL, also for a source in WGSL. */
export type Named = Pick<External, 'name' | 'type'>

/** The operations of a function; glsl.hpp describes the words. */
export interface Listing extends wasm.Listing {
  head: FunctionHead
}

export interface SourceText {
  text: string
  language: SourceLanguage
}

/** Starts the front end's wasm module, which otherwise starts when the first source is parsed. */
export const startFrontEnd = () => void wasm.glsl.get()

/** Parses source, passes it to `work` and then closes it. Throws a `WarpError` with the line, column and a caret for a mistake. */
export const withSource = <Result>(
  place: Place,
  { text, language }: SourceText,
  work: (source: OpenSource) => Result,
): Result =>
  wasm.glsl.use(
    ({ Source }) => new Source(text, language === 'wgsl'),
    (source) => work(new OpenSource(place, source, language)),
  )

/** Parsed source, in wasm memory. */
export class OpenSource {
  readonly functions: FunctionHead[]

  constructor(
    private readonly place: Place,
    private readonly source: wasm.Source,
    readonly language: SourceLanguage,
  ) {
    this.throwProblem()
    this.functions = source.functions()
  }

  private throwProblem() {
    const problem = this.source.problem()
    if (problem) throw this.place.error(problem)
  }

  /** Returns the function with the given name; without a name, the function `offset` or else the last one. */
  find(name: string | undefined): FunctionHead {
    const { functions, place } = this
    if (functions.length === 0)
      throw place.error('the source has no function; write one that returns a value.')
    const named = functions.filter((each) => each.name === (name ?? 'offset'))
    if (named.length > 0) return named.at(-1)!
    if (name === undefined) return functions.at(-1)!
    throw place.error(
      `the source has no function "${name}"; it has ${functions.map((each) => each.name).join(', ')}.`,
    )
  }

  /** Lowers a function. `maxIterations` is the option of this name, 0 or `untilEnd`. */
  list(head: FunctionHead, maxIterations = 0): Listing {
    const listing = this.source.lower(head.number, maxIterations)
    this.throwProblem()
    return { head, ...listing }
  }
}
