// A recorded function as a serialized module (src/module): a word stream outside of the wasm. Any number of shaders and CPU programs can
// be made from it.
import { WarpError } from '../../errors/errors.js'
import { oneOf } from '../../options/kinds.js'
import { core, type Module } from '../../wasm/core.js'
import { languages } from '../../wasm/tables.js'
import type { ReadAsFloats, Variable } from '../expression/shapes.js'

/** A shading language: GLSL ES 3.00 (WebGL 2), GLSL ES 1.00 (WebGL 1), or WGSL (WebGPU). */
export type Target = keyof typeof languages

export const targets = Object.keys(languages) as readonly Target[]

/** The kind of the option `target`. */
export const targetKind = oneOf(targets, 'glsl300')

export type SerializedModule = Uint32Array & {
  readonly isSerialized: unique symbol
  /** Maps the number of an input that is not a float in the host → how it is read as floats. */
  conversions: ReadonlyMap<number, ReadAsFloats>
}

/** A CPU program (src/eval/program.hpp): a word stream that outlives the session. */
export interface Program {
  words: Uint32Array
  instructions: number
  /** The inputs whose numbers the program takes, in order. */
  inputs: Variable[]
}

/** The host's name for an input or a result. */
type Naming = readonly [number: number, name: string]

export interface Names {
  inputs?: readonly Naming[]
  /** Default: all results, under their own names. */
  results?: readonly Naming[]
  /** Selects the inputs that frame constants are computed from; see compile/frame.ts. */
  isFrameConstant?: IsFrameConstant | undefined
  /** If true, noise that is finer than a pixel fades, which only a fragment shader can do. */
  fadesNoise?: boolean | undefined
  /**
   * If true, numbers that are less than a pixel outside of the domain of an operation are reflected, for fragment shaders; see
   * src/emit/borders.hpp.
   */
  reflectsAtBorders?: boolean | undefined
}

/** Tests for an input that is constant during a frame, and whose value the host knows. */
export type IsFrameConstant = (variable: Variable) => boolean

/** Moves everything that depends on frame constants alone into a separate result, and returns the number of vec4s in that result. */
function separateFrame(module: Module, isFrameConstant: IsFrameConstant | undefined): number {
  if (!isFrameConstant) return 0
  const constants = module.inputs().filter(isFrameConstant)
  return module.separate(constants.map(({ number }) => number))
}

/** Makes the program that computes the vec4s of the frame; `isRead` says which inputs it reads. `undefined` if there are no vec4s. */
export const makeFrame = (serialized: SerializedModule, isFrameConstant: IsFrameConstant) =>
  withModule(serialized, (module) => {
    const count = separateFrame(module, isFrameConstant)
    if (count === 0) return undefined
    const program = programOf(serialized, module, [module.results().length - 1])
    return program && { program, count, isRead: inputsRead(program) }
  })

/** Returns for each input of the program whether it is read. */
function inputsRead({ words, instructions, inputs }: Program): boolean[] {
  const sizes = inputs.map(({ shape: [columns, rows] }) => columns * rows)
  return Array.from(core.get().inputsRead(words, instructions, sizes), Boolean)
}

/** Shader code. */
export interface Text {
  code: string
  declarations: string
  /** The inputs that the code reads. */
  inputs: Variable[]
  stats: { nodes: number; operations: number; temporaries: number; vectors: number }
}

/** Writes shader code. With a `maxDepth` only depth decides where an expression is split, not the number of variables that it reads. */
export const writeText = (
  serialized: SerializedModule,
  target: Target,
  {
    inputs = [],
    results = [],
    isFrameConstant,
    fadesNoise = false,
    reflectsAtBorders = false,
  }: Names = {},
  maxDepth = 0,
): Text =>
  withModule(serialized, (module) => {
    separateFrame(module, isFrameConstant)
    const conversions = Array.from(serialized.conversions, ([number, { texts }]): Naming => [
      number,
      texts[target]!,
    ])
    const names = [...conversions, ...inputs]
    const { problem, ...text } = module.write(
      target,
      names.map(numberOf),
      names.map(nameOf),
      results.map(numberOf),
      results.map(nameOf),
      Math.min(maxDepth, 2 ** 30),
      fadesNoise,
      reflectsAtBorders,
    )
    if (problem) throw new WarpError(problem)
    return { ...text, inputs: withConversions(serialized, text.inputs) }
  })

const numberOf = ([number]: Naming) => number
const nameOf = ([, name]: Naming) => name

/** Returns all inputs, read or not. */
export const inputsOf = (serialized: SerializedModule): Variable[] =>
  withModule(serialized, (module) => withConversions(serialized, module.inputs()))

/** Returns the inputs that results depend on. `results` are their numbers. */
export const inputsReadBy = (
  serialized: SerializedModule,
  results: readonly number[],
): Variable[] =>
  withModule(serialized, (module) => withConversions(serialized, module.inputsRead(results)))

/** Returns the results in order. */
export const resultsOf = (serialized: SerializedModule): Variable[] =>
  withModule(serialized, (module) => module.results())

/**
 * Estimates the work of computing results, given by number: operations on single floats, whether there is noise, and whether only a GPU can
 * do it.
 */
export const costOf = (
  serialized: SerializedModule,
  results: readonly number[],
  isFrameConstant?: IsFrameConstant,
) =>
  withModule(serialized, (module) => {
    separateFrame(module, isFrameConstant)
    return module.cost(results)
  })

/**
 * Makes the CPU program of results, given by number; `undefined` if it would call a function of the host. With `isFrameConstant`
 * it reads the vec4s of the frame.
 */
export const makeProgram = (
  serialized: SerializedModule,
  results: readonly number[],
  isFrameConstant?: IsFrameConstant,
): Program | undefined =>
  withModule(serialized, (module) => {
    separateFrame(module, isFrameConstant)
    return programOf(serialized, module, results)
  })

/**
 * The phases and fronts of results (src/eval/phases.hpp), and the program that computes them. Phases are the arguments of waves and noises,
 * and the normal that results read; fronts are the arguments of functions that change within a short part of their argument's range.
 */
export interface Phases {
  program: Program
  /** For each phase, its number of components, and the distance that it may move between samples. */
  phases: readonly { size: number; step: number }[]
  /** 3 numbers per front: see src/eval/front.hpp. */
  fronts: readonly number[]
}

/** Finds the phases and fronts of results, given by number; `varying` are the inputs that differ by vertex. `undefined` if there are none. */
export const makePhases = (
  serialized: SerializedModule,
  results: readonly number[],
  varying: readonly number[],
): Phases | undefined =>
  withModule(serialized, (module) => {
    const { phases, fronts } = module.phases(results, varying)
    const isEmpty = !phases.length && !fronts.length
    const program = isEmpty
      ? undefined
      : programOf(serialized, module, [module.results().length - 1])
    return program && { program, phases, fronts: Array.from(fronts) }
  })

function programOf(
  serialized: SerializedModule,
  module: Module,
  results: readonly number[],
): Program | undefined {
  const { problem, words, instructions, inputs } = module.program(results)
  if (problem) throw new WarpError(problem)
  return words.length
    ? { words, instructions, inputs: withConversions(serialized, inputs) }
    : undefined
}

/** Calls `work` with the deserialized module, and deletes the module. */
const withModule = <Result>(
  serialized: SerializedModule,
  work: (module: Module) => Result,
): Result => core.use(({ Module }) => new Module(serialized), work)

/** Adds the conversions of inputs that are not floats in the host. */
const withConversions = (
  { conversions }: SerializedModule,
  inputs: readonly Variable[],
): Variable[] =>
  inputs.map((input) => {
    const read = conversions.get(input.number)
    return read ? { ...input, name: read.name ?? input.name, read } : input
  })
