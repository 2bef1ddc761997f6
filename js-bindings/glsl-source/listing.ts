// From shader text to a plain list of operations, once; it knows no session and outlives the wasm's memory.
import type { Place } from '../options/place.js'
import * as wasm from '../wasm/glsl.js'

export type FunctionHead = wasm.FunctionHead

/** What a text calls from outside: a uniform or an attribute of the text. */
export type External = wasm.HostName

/** A name with its type, as GLSL writes it. */
export type Named = Pick<External, 'name' | 'type'>

/** A function of a text; see glsl.hpp for its words. */
export interface Listing extends wasm.Listing {
  head: FunctionHead
}

/** Does some work with a text that was read, and closes it whatever happens. Throws a `WarpError` with line, column and a caret. */
export const withSource = <Result>(
  place: Place,
  text: string,
  work: (source: OpenSource) => Result,
): Result =>
  wasm.glsl.use(
    ({ Source }) => new Source(text),
    (source) => work(new OpenSource(place, source)),
  )

export class OpenSource {
  readonly functions: FunctionHead[]

  constructor(
    private readonly place: Place,
    private readonly source: wasm.Source,
  ) {
    this.throwProblem()
    this.functions = source.functions()
  }

  private throwProblem() {
    const problem = this.source.problem()
    if (problem) throw this.place.error(problem)
  }

  /** The one of that name; without a name `offset`, or the last. */
  find(name: string | undefined): FunctionHead {
    const { functions, place } = this
    if (functions.length === 0)
      throw place.error('the source has no function; write one that gives a value.')
    const named = functions.filter((each) => each.name === (name ?? 'offset'))
    if (named.length > 0) return named.at(-1)!
    if (name === undefined) return functions.at(-1)!
    throw place.error(
      `the source has no function "${name}"; there are ${functions.map((each) => each.name).join(', ')}.`,
    )
  }

  list(head: FunctionHead, maxIterations = 0): Listing {
    const listing = this.source.lower(head.number, maxIterations)
    this.throwProblem()
    return { head, ...listing }
  }
}
