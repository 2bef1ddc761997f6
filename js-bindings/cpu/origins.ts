// Where the inputs of a warp's program come from on the CPU: vertices, or uniforms, which are checked here.
import { WarpError } from '../errors/errors.js'
import { takeNumbers } from '../options/numbers.js'
import { isList, own } from '../options/options.js'
import type { Variable } from '../core/expression/shapes.js'
import { inputNumbers } from '../core/inputs/input-numbers.js'
import {
  type DeclaredUniform,
  isWhole,
  numbersFor,
  unlisted,
  withDeclared,
} from '../core/inputs/declared-uniforms.js'
import { type VertexInput, vertexInputs } from '../core/inputs/inputs.js'
import { type Uniforms, checkUniforms } from '../core/inputs/vertices.js'
import type { Program } from '../core/module/kept-module.js'
import { inputsRead } from '../wasm/evaluation.js'
import type { Stream } from '../wasm/machine-code.js'
import type { WarpProgram } from './warp-program.js'

/** A program's input, under the warp's name for it. */
interface Input {
  variable: Variable
  /** If it differs by vertex, which it is. */
  input?: VertexInput
  /** Whether the results depend on it. */
  isRead: boolean
}

/** Where a program's input comes from: its own numbers, which all vertices share, unless the caller puts others there. They
 * are zeros if it differs by vertex, or is not read and may be missing. */
export interface Origin extends Stream, Input {
  readonly numbers: number[]
}

/** What stays the same of these from call to call, by program and wanted results. */
export interface Reading {
  inputs: readonly Input[]
  /** The names of those that are no inputs of the warp. */
  parameters: ReadonlySet<string>
  /** What uniforms there are beside the inputs of a draw call. */
  known: ReadonlySet<string>
  /** Declared uniforms that the program does not have, which may be given nevertheless. */
  others: readonly (readonly [name: string, uniform: DeclaredUniform])[]
  /** Origins that nobody uses, so that a call need not make any. */
  spare: Origin[] | undefined
}

/** The wanted results by their array, of which there is one for each set of them: a name for it would be made at each call. */
const readings = new WeakMap<Program, Map<readonly number[], Reading>>()

export function readingOf(warp: WarpProgram, program: Program, wanted: readonly number[]): Reading {
  let known = readings.get(program)
  if (!known) readings.set(program, (known = new Map<readonly number[], Reading>()))
  let reading = known.get(wanted)
  if (!reading) known.set(wanted, (reading = read(warp, program, wanted)))
  return reading
}

function read(
  { declared, inputs }: WarpProgram,
  program: Program,
  wanted: readonly number[],
): Reading {
  // The first of two inputs that are one.
  const names = new Map(
    Object.entries(inputs)
      .reverse()
      .map(([input, number]) => [number, input]),
  )
  const parameters = new Set(
    program.inputs.filter(({ number }) => !names.has(number)).map(({ name }) => name),
  )
  const isRead = inputsRead(program, wanted)
  return {
    inputs: program.inputs.map((variable, i) => {
      const name = names.get(variable.number) ?? variable.name
      const isInput = names.has(variable.number) && name in vertexInputs
      const input = isInput && { input: name as VertexInput }
      return { variable: { ...variable, name }, isRead: isRead[i]!, ...input }
    }),
    parameters,
    known: new Set([...declared.keys(), ...parameters]),
    others: [...declared].filter(([name, { image }]) => !image && !parameters.has(name)),
    spare: undefined,
  }
}

function originOf(input: Input): Origin {
  const [columns, rows] = input.variable.shape
  const numbers = Array<number>(columns * rows).fill(0)
  return { ...input, numbers, values: numbers, size: numbers.length, isUniform: true }
}

/**
 * The program's inputs in order, the uniforms checked. They are the caller's until it gives them back by `keep`; meanwhile a
 * uniform's function may evaluate the same warp, which gets others.
 */
export function originsOf(
  method: string,
  { declared, valuesOfFrame }: WarpProgram,
  reading: Reading,
  given: Uniforms | undefined,
): Origin[] {
  checkUniforms(method, given, reading.known)
  const origins = reading.spare ?? reading.inputs.map(originOf)
  reading.spare = undefined
  let uniforms: Readonly<Record<string, unknown>> | undefined = given
  let frame: Readonly<Record<string, number[]>> | undefined
  if (valuesOfFrame) {
    uniforms = withDeclared(method, declared, given, reading.parameters)
    frame = valuesOfFrame(method, uniforms)
  } else
    for (const [name, { shape }] of reading.others) {
      const value = given && own(given, name)
      if (value !== undefined) numbersFor(placeOf(method, name), shape, value)
    }
  for (const origin of origins) {
    const { variable, input, isRead, numbers } = origin
    if (input) continue
    const { name } = variable
    const computed = frame && own(frame, name)
    if (computed) {
      // Any numbers: what divides by a uniform of 0 is infinite, or NaN.
      for (let i = 0; i < numbers.length; i++) numbers[i] = (computed as number[])[i]!
      continue
    }
    const uniform = valuesOfFrame ? undefined : declared.get(name)
    const value = uniforms && own(uniforms, name)
    if (value !== undefined) fill(method, origin, value, uniform)
    else if (uniform) fill(method, origin, valueOf(method, uniform), uniform, true)
    else if (isRead)
      throw new WarpError(
        `${method}: the warp reads "${name}"; give it a value in the uniforms, as in { ${JSON.stringify(name)}: ${numbers.length === 1 ? 0 : `[${numbers.map(() => 0)}]`} }.`,
      )
    else numbers.fill(0)
  }
  return origins
}

/** For the next call; what is the caller's own is let go. */
export function keep(reading: Reading, origins: Origin[]) {
  for (const origin of origins) {
    origin.values = origin.numbers
    origin.size = origin.numbers.length
    origin.isUniform = true
  }
  reading.spare = origins
}

/** `isOwn` says that it is the uniform's own value. */
function fill(
  method: string,
  { variable, numbers }: Origin,
  value: unknown,
  uniform: DeclaredUniform | undefined,
  isOwn = false,
) {
  // What mostly comes, without the words for what is wrong, which would be made at each call. A list of one number is no
  // value of a declared uniform.
  const isPlain = !variable.read && !(uniform && (isWhole(uniform) || isSingle(value)))
  if (isPlain && takeNumbers(numbers, value)) return
  const place = placeOf(method, variable.name)
  const fitting = uniform ? numbersFor(place, uniform.shape, value, isOwn) : value
  const read = inputNumbers(place, variable, fitting)
  for (let i = 0; i < read.length; i++) numbers[i] = read[i]!
}

const valueOf = (method: string, { value, numbers }: DeclaredUniform) =>
  value ? value() : unlisted(numbers(method))

const isSingle = (value: unknown) => isList(value) && value.length < 2

const placeOf = (method: string, name: string) => `${method}: the uniform "${name}"`
