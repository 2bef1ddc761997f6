// From shader text to a plain list of operations, once; it knows no session and outlives the wasm's memory.
import { type GlslModule, type SourceHandle, getGlsl } from '../wasm/glsl.js'
import { WarpError } from '../errors/errors.js'
import type { Shape } from '../core/expression/shapes.js'

/** What a text calls from outside: a parameter of a function, or a uniform or attribute of the text. */
export interface Named {
  name: string
  /** As GLSL writes it. */
  type: string
}

export interface External extends Named {
  isAttribute: boolean
  /** Whether the function reads it. */
  isRead: boolean
  shape: Shape
}

export interface FunctionHead extends Named {
  number: number
  parameters: (Named & { isOut: boolean })[]
}

/** A function of a text; see glsl.hpp for its words. */
export interface Listing {
  head: FunctionHead
  words: Uint32Array
  constants: Float64Array
  results: Uint32Array
  externals: External[]
  /** The names of functions that stay functions. */
  routines: string[]
}

/** Does some work with a text that was read, and closes it whatever happens. Throws a `WarpError` with line, column and a caret. */
export function withSource<Result>(
  method: string,
  text: string,
  work: (source: OpenSource) => Result,
): Result {
  const glsl = getGlsl()
  const handle = glsl.openSource(text)
  try {
    return work(new OpenSource(method, glsl, handle))
  } finally {
    if (!glsl.isBroken) glsl._closeSource(handle)
  }
}

export class OpenSource {
  readonly functions: FunctionHead[]

  constructor(
    private readonly method: string,
    private readonly glsl: GlslModule,
    private readonly handle: SourceHandle,
  ) {
    this.refuseProblem()
    this.functions = lines(glsl.functionLines(handle)).map(readHead)
  }

  private refuseProblem() {
    const problem = this.glsl.sourceProblem(this.handle)
    if (problem) throw new WarpError(`${this.method}: ${problem}`)
  }

  /** The one of that name; without a name `offset`, or the last. */
  find(name: string | undefined): FunctionHead {
    const { functions, method } = this
    if (functions.length === 0)
      throw new WarpError(`${method}: the source has no function; write one that gives a value.`)
    const named = functions.filter((each) => each.name === (name ?? 'offset'))
    if (named.length > 0) return named.at(-1)!
    if (name === undefined) return functions.at(-1)!
    throw new WarpError(
      `${method}: the source has no function "${name}"; there are ${functions.map((each) => each.name).join(', ')}.`,
    )
  }

  list(head: FunctionHead, maxIterations = 0): Listing {
    const { glsl, handle } = this
    glsl._lower(handle, head.number, maxIterations)
    this.refuseProblem()
    const words = (at: number, count: number) => glsl.HEAPU32.slice(at / 4, at / 4 + count)
    const constants = glsl._constants(handle) / 8
    return {
      head,
      words: words(glsl._words(handle), glsl._wordCount(handle)),
      constants: glsl.HEAPF64.slice(constants, constants + glsl._constantCount(handle)),
      results: words(glsl._results(handle), glsl._resultCount(handle)),
      externals: lines(glsl.nameLines(handle)).map(readExternal),
      routines: lines(glsl.routineLines(handle)),
    }
  }
}

const lines = (text: string) => text.split('\n').slice(0, -1)

function readHead(line: string): FunctionHead {
  const [number, type, name, ...parameters] = line.split(' ')
  return {
    number: Number(number),
    type: type!,
    name: name!,
    parameters: readParameters(parameters.join(' ')),
  }
}

/** `vec3 p` is read, `vec3&p` is written. */
const readParameters = (text: string) =>
  [...text.matchAll(/(\S+?)([ &])(\S+)/g)].map(([, type, mark, name]) => ({
    type: type!,
    name: name!,
    isOut: mark === '&',
  }))

function readExternal(line: string): External {
  const [kind, columns, rows, type, ...name] = line.split(' ')
  return {
    name: name.join(' '),
    type: type!,
    isAttribute: kind!.endsWith('in'),
    isRead: !kind!.startsWith('-'),
    shape: [Number(columns), Number(rows)],
  }
}
