// Calls the builder for each operation of a list, as a sketch would by hand. It uses only the public builder, so that this file's
// bundle contains no part of the compiler.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { glsl as wasm } from '../wasm/glsl.js'
import { Columns, Halves, halfOf, halvesOf, wholeOf, type GlslValue } from './halves.js'
import type { Listing } from './listing.js'
import { record, type Routine } from './record.js'

/** Maps codes to the builder's names of operations and to names of leaves; see codes.hpp. */
let operations: string[] | undefined

export interface ReplayInputs {
  /** The arguments of the function, in order. */
  arguments: readonly GlslValue[]
  /** Returns the uniform or attribute with an index among the externals. */
  external: (place: number) => GlslValue
  /** Samples the image with an index among the externals at a vec2, or fetches the texel with these integer coordinates. */
  texture: (place: number, at: Expression, isFetched: boolean) => Expression
  /** Returns the width and height of the image. */
  imageSize: (place: number) => Expression
}

/** Returns the results of the function, one expression per number. */
export function replay(glsl: Builder, listing: Listing, given: ReplayInputs): Expression[] {
  operations ??= wasm.get().codes()
  const { words, constants } = listing
  const routines: Routine[] = []
  let at = 0
  const word = () => words[at++]!

  /** Replays up to the end of the list, or of the current function's body, and returns the results. */
  const replayIn = (glsl: Builder, parameters: Expression[]): Expression[] => {
    // The upper half of an integer that is known to be small is `undefined`.
    const made: (Expression | undefined)[] = []
    const operandsOf = (count: number) =>
      Array.from({ length: count }, () => made[word()] ?? glsl.val!(0))
    const run = (end: string) => {
      while (at < words.length) {
        const name = operations![word()]!
        if (name === end) return
        if (name === 'define') define(word(), word())
        else if (name === 'fold') repeat(word(), word())
        else if (name === 'call') made.push(...routines[word()]!(glsl, operandsOf(word())))
        else made.push(operation(name))
      }
    }
    const define = (size: number, variables: number) => {
      routines.push(record(glsl, listing.routines[routines.length]!, size, variables, replayIn))
    }
    const repeat = (steps: number, count: number) => {
      const stateOf = (numbers: Expression[]) =>
        Object.fromEntries(numbers.map((number, i) => [`state${i}`, number]))
      const body = (states: object, step: Expression) => {
        made.push(step, ...(Object.values(states) as Expression[]))
        run('next')
        return stateOf(operandsOf(count))
      }
      const outcomes = glsl.repeat!(steps, stateOf(operandsOf(count)), body)
      made.push(...(Object.values(outcomes) as Expression[]))
    }
    const operation = (name: string): Expression | undefined => {
      switch (name) {
        case 'constant':
          return glsl.val!(constants[word()]!)
        case 'whole':
          return constantOf(glsl, constants[word()]!)
        case 'parameter':
          return parameters[word()]!
        case 'argument':
          return partOf(given.arguments[word()]!, word(), word())
        case 'uniform':
          return partOf(given.external(word()), word(), word())
        case 'component':
          return componentOf(made[word()]!, word(), word())
        case 'intOfHalves':
        case 'uintOfHalves': {
          const [low, high] = [1, 2].map((i) => made[words[at + i]!])
          at += 3
          if (high) return wholeOf(glsl, low!, high)
          return glsl[name === 'intOfHalves' ? 'int' : 'bitsOf']!(low!)
        }
        case 'texel':
        case 'fetchedTexel':
          return given.texture(word(), made[word()]!, name === 'fetchedTexel')
        case 'imageSize':
          return given.imageSize(word())
        default:
          return glsl[name]!(...operandsOf(word()))
      }
    }
    run('end')
    return at < words.length
      ? operandsOf(word())
      : Array.from(listing.results, (place) => made[place]!)
  }
  return replayIn(glsl, [])
}

function constantOf(glsl: Builder, value: number): Expression {
  const given = halvesOf(glsl, value)
  return given instanceof Halves ? wholeOf(glsl, given.low, given.high) : glsl.int!(given)
}

/** Returns a component of an argument or a uniform; the layout also selects one half of an integer. */
function partOf(value: GlslValue, place: number, layout: number): Expression | undefined {
  if (value instanceof Columns) {
    const rows = layout & 15
    return componentOf(value.vectors[Math.floor(place / rows)]!, place % rows, (1 << 4) | rows)
  }
  const half = halfOf(value, layout >= highHalf)
  return half && componentOf(half, place, layout % highHalf)
}

/** Recorder::highHalf. */
const highHalf = 128

type Methods = Record<string, (...operands: unknown[]) => Expression>
const methodsOf = (value: Expression) => value as unknown as Methods

/** Returns a component of a number, a vector or (in column-major order) a matrix; `layout` has columns and rows, 4 bits each. */
function componentOf(value: Expression, place: number, layout: number): Expression {
  const [columns, rows] = [layout >> 4, layout & 15]
  if (columns * rows === 1) return value
  const vector = columns === 1 ? value : methodsOf(value).column!(Math.floor(place / rows))
  return methodsOf(vector)['xyzw'[place % rows]!]!()
}

/** Combines numbers into a value of a GLSL type. */
export function pack(glsl: Builder, type: string, numbers: readonly Expression[]): Expression {
  if (numbers.length === 1) return numbers[0]!
  const [, matrix, size] = /^(mat)?\w*?(\d)(?:x\2)?$/.exec(type) ?? []
  if (!matrix) return glsl[`vec${numbers.length}`]!(...numbers)
  return glsl[`mat${size}`]!(...numbers)
}
