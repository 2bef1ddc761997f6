// Calls the builder for each operation of a list: what a sketch would have written by hand. Only the public builder is
// used, so that nothing of the compiler is in this file's bundle.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { getGlsl } from '../wasm/glsl.js'
import { Columns, type Given as Value, Halves, halfOf, halvesOf, wholeOf } from './halves.js'
import type { Listing } from './listing.js'
import { type Routine, record } from './record.js'

/** By code, the builder's names of operations, and codes.hpp's of leaves. */
let operations: string[] | undefined

export interface Given {
  /** The arguments of the function, in order. */
  arguments: readonly Value[]
  /** The uniform or attribute of that place among the externals. */
  external: (place: number) => Value
  /** The texel at a vec2 of the image of that place: between the texels, or that with these numbers. */
  texture: (place: number, at: Expression, isFetched: boolean) => Expression
  /** Its width and height. */
  imageSize: (place: number) => Expression
}

/** The numbers that the function gives. */
export function replay(glsl: Builder, listing: Listing, given: Given): Expression[] {
  operations ??= getGlsl().codes().split(' ')
  const { words, constants } = listing
  const routines: Routine[] = []
  let at = 0
  const word = () => words[at++]!

  /** Until the end of the list, or of the function whose body it is, whose results it gives then. */
  const replayIn = (glsl: Builder, parameters: Expression[]): Expression[] => {
    // The upper half of a whole number that is known to be small is missing.
    const made: (Expression | undefined)[] = []
    const listed = (count: number) =>
      Array.from({ length: count }, () => made[word()] ?? glsl.val!(0))
    const run = (end: string) => {
      while (at < words.length) {
        const name = operations![word()]!
        if (name === end) return
        if (name === 'define') define(word(), word())
        else if (name === 'fold') repeat(word(), word())
        else if (name === 'call') made.push(...routines[word()]!(glsl, listed(word())))
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
        return stateOf(listed(count))
      }
      const outcomes = glsl.repeat!(steps, stateOf(listed(count)), body)
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
          return glsl[name]!(...listed(word()))
      }
    }
    run('end')
    return at < words.length ? listed(word()) : Array.from(listing.results, (place) => made[place]!)
  }
  return replayIn(glsl, [])
}

function constantOf(glsl: Builder, value: number): Expression {
  const given = halvesOf(glsl, value)
  return given instanceof Halves ? wholeOf(glsl, given.low, given.high) : glsl.int!(given)
}

/** Of an argument or a uniform, where the layout says of which half, too. */
function partOf(value: Value, place: number, layout: number): Expression | undefined {
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

/** A number of a number, a vector or, column by column, a matrix; `layout` is columns and rows, four bits each. */
function componentOf(value: Expression, place: number, layout: number): Expression {
  const [columns, rows] = [layout >> 4, layout & 15]
  if (columns * rows === 1) return value
  const vector = columns === 1 ? value : methodsOf(value).column!(Math.floor(place / rows))
  return methodsOf(vector)['xyzw'[place % rows]!]!()
}

/** Numbers together again, as a type of GLSL. */
export function pack(glsl: Builder, type: string, numbers: readonly Expression[]): Expression {
  if (numbers.length === 1) return numbers[0]!
  const [, matrix, size] = /^(mat)?\w*?(\d)(?:x\2)?$/.exec(type) ?? []
  if (!matrix) return glsl[`vec${numbers.length}`]!(...numbers)
  return glsl[`mat${size}`]!(...numbers)
}
