// What is kept of a sketch's function when it is over: the words of a module (src/module), outside of the wasm. Texts and
// programs are made of them as often as need be.
import { type Module, core } from '../../wasm/core.js'
import { WarpError, describe } from '../../errors/errors.js'
import { oneOf } from '../../options/kinds.js'
import type { ReadAsFloats, Variable } from '../expression/shapes.js'
import { languages } from '../../wasm/tables.js'

/** A shading language: GLSL ES 3.00 (WebGL 2), GLSL ES 1.00 (WebGL 1), or WGSL (WebGPU). */
export type Target = keyof typeof languages

export const targets = Object.keys(languages) as readonly Target[]

/** The kind of the option `target`. */
export const targetKind = oneOf(targets, 'glsl300')

export function checkTarget(target: unknown = targets[0]): Target {
  if (targets.includes(target as Target)) return target as Target
  throw new WarpError(
    `The option "target" must be one of ${targets.join(', ')}, but is ${describe(target)}.`,
  )
}

export type KeptModule = Uint32Array & {
  readonly kept: unique symbol
  /** Of inputs that are no floats of the host, by number. */
  others: ReadonlyMap<number, ReadAsFloats>
}

/** src/eval/program.hpp: plain words, which outlive the session. */
export interface Program {
  words: Uint32Array
  instructions: number
  /** Whose numbers it wants, in order. */
  inputs: Variable[]
}

/** What the host calls an input or a result. */
type Naming = readonly [number: number, name: string]

export interface Names {
  inputs?: readonly Naming[]
  /** All results under their own names, unless given. */
  results?: readonly Naming[]
  /** What the host computes with once a frame; see compile/frame.ts. */
  known?: Known | undefined
}

/** Whether the host knows an input's numbers. */
export type Known = (variable: Variable) => boolean

/** Tells it of those, and gives how many vec4s it computes of them once a frame. */
function separate(module: Module, isKnown: Known | undefined): number {
  if (!isKnown) return 0
  const known = module.inputs().filter(isKnown)
  return module.separate(known.map(({ number }) => number))
}

/** Makes the program that computes those vec4s; `isRead` says which inputs it reads. `undefined` if there are none. */
export const makeFrame = (kept: KeptModule, isKnown: Known) =>
  reading(kept, (module) => {
    const count = separate(module, isKnown)
    if (count === 0) return undefined
    const program = programOf(kept, module, [module.results().length - 1])
    return program && { program, count, isRead: inputsRead(program) }
  })

/** Finds which of its inputs the program reads. */
function inputsRead({ words, instructions, inputs }: Program): boolean[] {
  const sizes = inputs.map(({ shape: [columns, rows] }) => columns * rows)
  return Array.from(core.get().inputsRead(words, instructions, sizes), Boolean)
}

export interface Text {
  code: string
  declarations: string
  /** The host's expressions that the text reads. */
  inputs: Variable[]
  stats: { nodes: number; operations: number; temporaries: number; vectors: number }
}

/** A `maxDepth` makes temporaries by depth, and not by how much an expression reads. */
export const writeText = (
  kept: KeptModule,
  target: Target,
  { inputs = [], results = [], known }: Names = {},
  maxDepth = 0,
): Text =>
  reading(kept, (module) => {
    separate(module, known)
    const others = Array.from(kept.others, ([number, { texts }]): Naming => [
      number,
      texts[target]!,
    ])
    const names = [...others, ...inputs]
    const { problem, ...text } = module.write(
      target,
      names.map(numberOf),
      names.map(nameOf),
      results.map(numberOf),
      results.map(nameOf),
      Math.min(maxDepth, 2 ** 30),
    )
    if (problem) throw new WarpError(problem)
    return { ...text, inputs: withReads(kept, text.inputs) }
  })

const numberOf = ([number]: Naming) => number
const nameOf = ([, name]: Naming) => name

/** All inputs, read or not. */
export const inputsOf = (kept: KeptModule): Variable[] =>
  reading(kept, (module) => withReads(kept, module.inputs()))

/** Finds the inputs that results depend on. `results` are their numbers. */
export const inputsReadBy = (kept: KeptModule, results: readonly number[]): Variable[] =>
  reading(kept, (module) => withReads(kept, module.inputsRead(results)))

/** The results, in their order. */
export const resultsOf = (kept: KeptModule): Variable[] =>
  reading(kept, (module) => module.results())

/** For the CPU, of results by number; nothing if it would call a function of the host. With `known` it reads vec4s of the frame. */
export const makeProgram = (
  kept: KeptModule,
  results: readonly number[],
  known?: Known,
): Program | undefined =>
  reading(kept, (module) => {
    separate(module, known)
    return programOf(kept, module, results)
  })

function programOf(
  kept: KeptModule,
  module: Module,
  results: readonly number[],
): Program | undefined {
  const { problem, words, instructions, inputs } = module.program(results)
  if (problem) throw new WarpError(problem)
  return words.length ? { words, instructions, inputs: withReads(kept, inputs) } : undefined
}

const reading = <Result>(kept: KeptModule, work: (module: Module) => Result): Result =>
  core.use(({ Module }) => new Module(kept), work)

/** Inputs, each with how it is read if it is no float of the host. */
const withReads = ({ others }: KeptModule, inputs: readonly Variable[]): Variable[] =>
  inputs.map((input) => {
    const read = others.get(input.number)
    return read ? { ...input, name: read.name ?? input.name, read } : input
  })
