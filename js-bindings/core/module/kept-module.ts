// What is kept of a sketch's function when it is over: the words of a module (src/module), outside of the wasm. Texts and
// programs are made of them as often as need be.
import { type Core, type Reading, getCore, laid } from '../../wasm/core.js'
import { WarpError, describe } from '../../errors/errors.js'
import type { ReadAsFloats, Variable } from '../expression/shapes.js'
import { languages } from '../../wasm/tables.js'

/** A shading language: GLSL ES 3.00 (WebGL 2), GLSL ES 1.00 (WebGL 1), or WGSL (WebGPU). */
export type Target = keyof typeof languages

export const targets = Object.keys(languages) as readonly Target[]

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

/** What the host calls inputs and results, by number. */
export interface Names {
  inputs?: readonly (readonly [number: number, name: string])[]
  /** All results under their own names, unless given. */
  results?: readonly (readonly [number: number, name: string])[]
  /** What the host computes with once a frame; see compile/frame.ts. */
  known?: Known | undefined
}

/** Whether the host knows an input's numbers. */
export type Known = (variable: Variable) => boolean

/** Tells it of those, and gives how many vec4s it computes of them once a frame. */
function separate(core: Core, open: Reading, isKnown: Known | undefined): number {
  if (!isKnown) return 0
  for (const variable of readLines(core.allInputLines(open)))
    if (isKnown(variable)) core._knowInput(open, variable.number)
  return core._separate(open)
}

/** Makes the program that computes those vec4s; `isRead` says which inputs it reads. `undefined` if there are none. */
export const makeFrame = (module: KeptModule, isKnown: Known) =>
  reading(module, (core, open) => {
    const count = separate(core, open, isKnown)
    if (count === 0) return undefined
    const program = programOf(core, module, open, [readLines(core.outputLines(open)).length - 1])
    return program && { program, count, isRead: inputsRead(core, open, program) }
  })

/** Finds which of its inputs the program reads that was just made. */
function inputsRead(core: Core, open: Reading, { inputs }: Program): boolean[] {
  let first = 0
  return inputs.map(({ shape: [columns, rows] }) => {
    const count = columns * rows
    first += count
    return core._programReads(open, first - count, count) !== 0
  })
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
  module: KeptModule,
  target: Target,
  { inputs = [], results = [], known }: Names = {},
  maxDepth = 0,
): Text =>
  reading(module, (core, open) => {
    separate(core, open, known)
    for (const [number, { texts }] of module.others) core.nameInput(open, number, texts[target]!)
    for (const [number, name] of inputs) core.nameInput(open, number, name)
    for (const [number, name] of results) core.nameResult(open, number, name)
    if (!core.writeText(open, target, Math.min(maxDepth, 2 ** 30)))
      throw new WarpError(core.readingProblem(open))
    return {
      code: core.code(open),
      declarations: core.declarations(open),
      inputs: readLines(core.inputLines(open), module),
      stats: {
        nodes: core._nodeCount(open),
        operations: core._operationCount(open),
        temporaries: core._temporaryCount(open),
        vectors: core._vectorCount(open),
      },
    }
  })

/** All inputs, read or not. */
export const inputsOf = (module: KeptModule): Variable[] =>
  reading(module, (core, open) => readLines(core.allInputLines(open), module))

/** The results, in their order. */
export const resultsOf = (module: KeptModule): Variable[] =>
  reading(module, (core, open) => readLines(core.outputLines(open)))

/** For the CPU, of results by number; nothing if it would call a function of the host. With `known` it reads vec4s of the frame. */
export const makeProgram = (
  module: KeptModule,
  results: readonly number[],
  known?: Known,
): Program | undefined =>
  reading(module, (core, open) => {
    separate(core, open, known)
    return programOf(core, module, open, results)
  })

function programOf(
  core: Core,
  module: KeptModule,
  open: Reading,
  results: readonly number[],
): Program | undefined {
  for (const number of results) core._wantResult(open, number)
  if (!core._makeProgram(open)) {
    const problem = core.readingProblem(open)
    if (problem) throw new WarpError(problem)
    return undefined
  }
  const at = core._programWords(open) / 4
  return {
    words: core.HEAPU32.slice(at, at + core._programSize(open)),
    instructions: core._instructionCount(open),
    inputs: readLines(core.allInputLines(open), module),
  }
}

function reading<Result>(module: KeptModule, work: (core: Core, open: Reading) => Result): Result {
  const core = getCore()
  const open = laid(core, module, (memory) => core._openReading(memory, module.length))
  try {
    return work(core, open)
  } finally {
    if (!core.isBroken) core._closeReading(open)
  }
}

/** Results or, of a `module`, inputs. */
const readLines = (lines: string, module?: KeptModule): Variable[] =>
  lines
    .split('\n')
    .slice(0, -1)
    .map((line) => {
      const [columns, rows, number] = line.split(' ', 3).map(Number)
      const read = module?.others.get(number!)
      const name = read?.name ?? line.replace(/^\d+ \d+ \d+ /, '')
      return { name, shape: [columns!, rows!], number: number!, ...(read && { read }) }
    })
