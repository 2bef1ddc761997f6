// Where the inputs of a warp's program come from on the CPU: vertices, or uniforms, which are checked here.
import { WarpError } from '../checks/errors.js'
import { own } from '../checks/options.js'
import type { Variable } from '../expression/shapes.js'
import { inputNumbers } from '../inputs/input-numbers.js'
import { withDeclared } from '../inputs/declared-uniforms.js'
import { type VertexInput, vertexInputs } from '../inputs/inputs.js'
import { type Uniforms, checkUniforms } from '../inputs/vertices.js'
import type { Program } from '../module/kept-module.js'
import { inputsRead } from '../wasm/evaluation.js'
import type { Stream } from '../wasm/machine-code.js'
import type { WarpProgram } from './warp-program.js'

/** Where a program's input comes from: the numbers that all vertices share, zeros if it differs by vertex, or is not read and
 * may be missing. */
export interface Origin extends Stream {
  /** If it differs by vertex, which it is. */
  input?: VertexInput
  /** Whether the results depend on it. */
  isRead: boolean
  values: number[]
}

/** What stays the same of these from call to call, by program and wanted results. */
interface Reading {
  inputs: readonly { variable: Variable; origin: Origin }[]
  /** The names of those that are no inputs of the warp. */
  parameters: ReadonlySet<string>
  /** What uniforms there are beside the inputs of a draw call. */
  known: ReadonlySet<string>
}

/** The wanted results by their array, of which there is one for each set of them: a name for it would be made at each call. */
const readings = new WeakMap<Program, Map<readonly number[], Reading>>()

function readingOf(warp: WarpProgram, program: Program, wanted: readonly number[]): Reading {
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
      const values = Array<number>(variable.shape[0] * variable.shape[1]).fill(0)
      const isInput = names.has(variable.number) && name in vertexInputs
      const input = isInput && { input: name as VertexInput }
      const origin = { isRead: isRead[i]!, values, size: values.length, isUniform: true }
      return { variable: { ...variable, name }, origin: { ...origin, ...input } }
    }),
    parameters,
    known: new Set([...declared.keys(), ...parameters]),
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
  const { declared, valuesOfFrame } = warp
  let uniforms: Readonly<Record<string, unknown>> = given ?? {}
  if (declared.size > 0 || valuesOfFrame) {
    const all = withDeclared(method, declared, given, parameters)
    uniforms = Object.assign(all, valuesOfFrame?.(method, all))
  }
  return inputs.map(({ variable, origin }) => {
    const { name } = variable
    const { input, isRead, values, size } = origin
    const value = input ? undefined : own(uniforms, name)
    if (value !== undefined) {
      const values = inputNumbers(`${method}: the uniform "${name}"`, variable, value)
      return { isRead, values, size, isUniform: true }
    }
    if (input || !isRead) return origin
    throw new WarpError(
      `${method}: the warp reads "${name}"; give it a value in the uniforms, as in { ${JSON.stringify(name)}: ${size === 1 ? 0 : `[${values}]`} }.`,
    )
  })
}
