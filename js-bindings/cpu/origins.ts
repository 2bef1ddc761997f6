// Where the inputs of a warp's program come from on the CPU: vertices, or uniforms, which are checked here.
import { WarpError } from '../checks/errors.js'
import type { Variable } from '../expression/shapes.js'
import { inputNumbers } from '../inputs/input-numbers.js'
import { withDeclared } from '../inputs/declared-uniforms.js'
import { type VertexInput, vertexInputs } from '../inputs/inputs.js'
import { type Uniforms, checkUniforms } from '../inputs/vertices.js'
import type { Program } from '../module/kept-module.js'
import { inputsRead } from '../wasm/evaluation.js'
import type { WarpProgram } from './warp-program.js'

/** Where a program's input comes from. */
export interface Origin {
  /** If it differs by vertex, which it is. */
  input?: VertexInput
  /** Whether the results depend on it. */
  isRead: boolean
  /** The numbers that all vertices share; zeros if it differs by vertex, or is not read and may be missing. */
  values: number[]
}

/** What stays the same of these from call to call, by program and wanted results. */
interface Reading {
  inputs: readonly { variable: Variable; origin: Origin }[]
  /** Those that are no inputs of the warp. */
  parameters: readonly Variable[]
  /** What uniforms there are beside the inputs of a draw call. */
  known: ReadonlySet<string>
}

const readings = new WeakMap<Program, Map<string, Reading>>()

function readingOf(warp: WarpProgram, program: Program, wanted: readonly number[]): Reading {
  let known = readings.get(program)
  if (!known) readings.set(program, (known = new Map<string, Reading>()))
  const key = wanted.join()
  let reading = known.get(key)
  if (!reading) known.set(key, (reading = read(warp, program, wanted)))
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
  const parameters = program.inputs.filter(({ number }) => !names.has(number))
  const isRead = inputsRead(program, wanted)
  return {
    inputs: program.inputs.map((variable, i) => {
      const name = names.get(variable.number) ?? variable.name
      const values = Array<number>(variable.shape[0] * variable.shape[1]).fill(0)
      const isInput = names.has(variable.number) && name in vertexInputs
      const input = isInput && { input: name as VertexInput }
      return { variable: { ...variable, name }, origin: { ...input, isRead: isRead[i]!, values } }
    }),
    parameters,
    known: new Set([...declared.keys(), ...parameters.map(({ name }) => name)]),
  }
}

/** The program's inputs in order, the uniforms checked. */
export function originsOf(
  method: string,
  warp: WarpProgram,
  program: Program,
  wanted: readonly number[],
  given: Uniforms | undefined,
): Origin[] {
  const { inputs, parameters, known } = readingOf(warp, program, wanted)
  checkUniforms(method, given, known)
  const uniforms = withDeclared(method, warp.declared, given, parameters)
  Object.assign(uniforms, warp.valuesOfFrame?.(method, uniforms))
  return inputs.map(({ variable, origin }) => {
    const { name } = variable
    const { input, isRead, values } = origin
    const value = input ? undefined : uniforms[name]
    if (value !== undefined)
      return { isRead, values: inputNumbers(`${method}: the uniform "${name}"`, variable, value) }
    if (input || !isRead) return origin
    throw new WarpError(
      `${method}: the warp reads "${name}"; give it a value in the uniforms, as in { ${JSON.stringify(name)}: ${values.length === 1 ? 0 : `[${values}]`} }.`,
    )
  })
}
