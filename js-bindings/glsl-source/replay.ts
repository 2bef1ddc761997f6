// Calls the builder for each operation of a listing, as a sketch would. It uses only the public builder, so that the bundle with this
// file contains no part of the compiler.
import type { Builder } from '../core/expression/builder.js'
import type { Expression } from '../core/expression/expression.js'
import { glsl as wasm } from '../wasm/glsl.js'
import { Columns, Halves, halfOf, halvesOf, recombine, type GlslValue } from './halves.js'
import type { Listing } from './listing.js'
import { record, sessionOf, type Routine } from './record.js'

/** The number of steps of a loop that runs until its first state says that it has ended. Equal to `Builder::uncounted` in C++. */
const uncounted = -1

/** Maps codes → the builder's names of operations, or the names of leaves and instructions; see codes.hpp. */
let operationNames: string[] | undefined

export interface ReplayInputs {
  /** The arguments of the function, in order. */
  arguments: readonly GlslValue[]
  /** Returns the uniform or attribute with this index among the externals. */
  external: (index: number) => GlslValue
  /**
   * Reads the image with this index among the externals: fetches the texel with integer coordinates if `isFetched`, otherwise samples it
   * at a vec2.
   */
  texture: (index: number, coordinates: Expression, isFetched: boolean) => Expression
  /** Returns the width and height of the image with this index. */
  imageSize: (index: number) => Expression
}

/** Returns the results of the function, one expression per number. */
export function replay(glsl: Builder, listing: Listing, inputs: ReplayInputs): Expression[] {
  operationNames ??= wasm.get().codes()
  const { words, constants } = listing
  const routines: Routine[] = []
  let position = 0
  const nextWord = () => words[position++]!

  /** Replays up to the end of the listing, or of the current function's body, and returns the results. */
  const replayBody = (glsl: Builder, parameters: Expression[]): Expression[] => {
    // The upper half of an integer that is known to be small is `undefined`.
    const values: (Expression | undefined)[] = []
    const nextOperands = (count: number) =>
      Array.from({ length: count }, () => values[nextWord()] ?? glsl.val!(0))
    const runUntil = (end: string) => {
      while (position < words.length) {
        const name = operationNames![nextWord()]!
        if (name === end) return
        if (name === 'define') define(nextWord(), nextWord())
        else if (name === 'fold') repeat(nextWord(), nextWord())
        else if (name === 'call')
          values.push(...routines[nextWord()]!(glsl, nextOperands(nextWord())))
        else values.push(runOperation(name))
      }
    }
    const define = (size: number, variables: number) => {
      routines.push(record(glsl, listing.routines[routines.length]!, size, variables, replayBody))
    }
    const repeat = (steps: number, count: number) => {
      const finalStates = sessionOf(glsl).repeat(
        steps || uncounted,
        nextOperands(count),
        (states, step) => {
          values.push(step, ...states)
          runUntil('next')
          return nextOperands(count)
        },
      )
      values.push(...finalStates)
    }
    const runOperation = (name: string): Expression | undefined => {
      switch (name) {
        case 'constant':
          return glsl.val!(constants[nextWord()]!)
        case 'whole':
          return integerConstant(glsl, constants[nextWord()]!)
        case 'parameter':
          return parameters[nextWord()]!
        case 'argument':
          return partOf(inputs.arguments[nextWord()]!, nextWord(), nextWord())
        case 'uniform':
          return partOf(inputs.external(nextWord()), nextWord(), nextWord())
        case 'component':
          return componentOf(values[nextWord()]!, nextWord(), nextWord())
        case 'intOfHalves':
        case 'uintOfHalves': {
          const [low, high] = [1, 2].map((i) => values[words[position + i]!])
          position += 3
          if (high) return recombine(glsl, low!, high)
          return glsl[name === 'intOfHalves' ? 'int' : 'bitsOf']!(low!)
        }
        case 'texel':
        case 'fetchedTexel':
          return inputs.texture(nextWord(), values[nextWord()]!, name === 'fetchedTexel')
        case 'imageSize':
          return inputs.imageSize(nextWord())
        default:
          return glsl[name]!(...nextOperands(nextWord()))
      }
    }
    runUntil('end')
    return position < words.length
      ? nextOperands(nextWord())
      : Array.from(listing.results, (index) => values[index]!)
  }
  return replayBody(glsl, [])
}

function integerConstant(glsl: Builder, value: number): Expression {
  const halves = halvesOf(glsl, value)
  return halves instanceof Halves ? recombine(glsl, halves.low, halves.high) : glsl.int!(halves)
}

/** Returns a component of an argument or a uniform; `layout` is that of `componentOf`, plus `highHalf` for the upper half of an integer. */
function partOf(value: GlslValue, index: number, layout: number): Expression | undefined {
  if (value instanceof Columns) {
    const rows = layout & 15
    return componentOf(value.vectors[Math.floor(index / rows)]!, index % rows, (1 << 4) | rows)
  }
  const half = halfOf(value, layout >= highHalf)
  return half && componentOf(half, index, layout % highHalf)
}

/** Equal to Recorder::highHalf in C++. */
const highHalf = 128

type Methods = Record<string, (...operands: unknown[]) => Expression>
const methodsOf = (value: Expression) => value as unknown as Methods

/**
 * Returns the component with this index of a number, a vector or (in column-major order) a matrix; `layout` holds the numbers of columns
 * and rows, 4 bits each.
 */
function componentOf(value: Expression, index: number, layout: number): Expression {
  const [columns, rows] = [layout >> 4, layout & 15]
  if (columns * rows === 1) return value
  const vector = columns === 1 ? value : methodsOf(value).column!(Math.floor(index / rows))
  return methodsOf(vector)['xyzw'[index % rows]!]!()
}

/** Combines numbers into a value of a GLSL type. */
export function pack(glsl: Builder, type: string, numbers: readonly Expression[]): Expression {
  if (numbers.length === 1) return numbers[0]!
  const [, matrix, size] = /^(mat)?\w*?(\d)(?:x\2)?$/.exec(type) ?? []
  if (!matrix) return glsl[`vec${numbers.length}`]!(...numbers)
  return glsl[`mat${size}`]!(...numbers)
}
