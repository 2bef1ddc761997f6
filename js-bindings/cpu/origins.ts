// Reads the inputs of a warp's program on the CPU: from vertices, and from uniforms, which this file checks.
import type { Variable } from '../core/expression/shapes.js'
import { withDeclared, type DeclaredUniform } from '../core/inputs/declared-uniforms.js'
import { inputNumbers } from '../core/inputs/input-numbers.js'
import { vertexInputs, type VertexInput } from '../core/inputs/inputs.js'
import { isWhole, numbersFor, scalarOrArray } from '../core/inputs/uniform-values.js'
import { checkUniforms, type Uniforms } from '../core/inputs/vertices.js'
import type { ResultSet } from '../core/module/result-set.js'
import type { Program } from '../core/module/serialized-module.js'
import { isList, ownProperty } from '../options/guards.js'
import { copyNumbers } from '../options/numbers.js'
import type { Place } from '../options/place.js'
import { inputsRead } from './analyse-program.js'
import type { Stream } from './machine-code.js'
import { Pool } from './pool.js'
import type { WarpProgram } from './warp-program.js'

/** An input of a program, with the warp's name for it. */
interface Input {
  variable: Variable
  /** Present for an input that differs by vertex. */
  input?: VertexInput
  /** True if the results depend on the input. */
  isRead: boolean
}

/** The source of an input's numbers. By default it is `numbers`, which all vertices share. These are zeros for an input that differs by
 * vertex, and for an input that has no value and is not read. */
export interface Origin extends Stream, Input {
  readonly numbers: number[]
}

/** Prepares reading the inputs of a program; the same for all calls with the same results. */
export interface InputPlan {
  /** Names of the program's inputs that are not inputs of the warp. */
  parameters: ReadonlySet<string>
  /** Names of the uniforms for which a caller may pass values, besides the inputs of a draw call. */
  known: ReadonlySet<string>
  /** Declared uniforms that the program does not read; values for them are checked nevertheless. */
  unread: readonly (readonly [name: string, uniform: DeclaredUniform])[]
  origins: Pool<Origin[]>
}

const plans = new WeakMap<Program, Map<ResultSet, InputPlan>>()

/** Returns the plan for a program and results, which is made once. */
export function planInputs(warp: WarpProgram, program: Program, wanted: ResultSet): InputPlan {
  let byResults = plans.get(program)
  if (!byResults) plans.set(program, (byResults = new Map<ResultSet, InputPlan>()))
  let plan = byResults.get(wanted)
  if (!plan) byResults.set(wanted, (plan = makePlan(warp, program, wanted)))
  return plan
}

function makePlan(
  { declared, inputs }: WarpProgram,
  program: Program,
  wanted: ResultSet,
): InputPlan {
  // Of two inputs with the same number, the first one counts.
  const names = new Map(
    Object.entries(inputs)
      .reverse()
      .map(([input, number]) => [number, input]),
  )
  const parameters = new Set(
    program.inputs.filter(({ number }) => !names.has(number)).map(({ name }) => name),
  )
  const isRead = inputsRead(program, wanted.numbers)
  const inputsOfWarp = program.inputs.map((variable, i): Input => {
    const name = names.get(variable.number) ?? variable.name
    const isInput = names.has(variable.number) && name in vertexInputs
    const input = isInput && { input: name as VertexInput }
    return { variable: { ...variable, name }, isRead: isRead[i]!, ...input }
  })
  return {
    parameters,
    known: new Set([...declared.keys(), ...parameters]),
    unread: [...declared].filter(([name, { image }]) => !image && !parameters.has(name)),
    origins: new Pool(() => inputsOfWarp.map(originOf)),
  }
}

function originOf(input: Input): Origin {
  const [columns, rows] = input.variable.shape
  const numbers = Array<number>(columns * rows).fill(0)
  return { ...input, numbers, values: numbers, size: numbers.length, isUniform: true }
}

/**
 * Returns the sources of the program's inputs in order, with checked uniforms. The caller owns them until it calls
 * `releaseOrigins`; if a uniform's function evaluates the same warp in between, that call gets other origins.
 */
export function originsOf(
  place: Place,
  { declared, frameConstants }: WarpProgram,
  plan: InputPlan,
  passed: Uniforms | undefined,
): Origin[] {
  checkUniforms(place, passed, plan.known)
  const origins = plan.origins.take()
  let uniforms: Readonly<Record<string, unknown>> | undefined = passed
  let frame: Readonly<Record<string, readonly number[]>> | undefined
  if (frameConstants) {
    uniforms = withDeclared(place, declared, passed, plan.parameters)
    frame = frameConstants(place, uniforms)
  } else
    for (const [name, { shape }] of plan.unread) {
      const value = passed && ownProperty(passed, name)
      if (value !== undefined) numbersFor(place.uniform(name), shape, value)
    }
  for (const origin of origins) {
    const { variable, input, isRead, numbers } = origin
    if (input) continue
    const { name } = variable
    const computed = frame && ownProperty(frame, name)
    if (computed) {
      // Frame constants may be infinite or NaN, as after a division by a uniform that is 0.
      for (let i = 0; i < numbers.length; i++) numbers[i] = (computed as readonly number[])[i]!
      continue
    }
    const uniform = frameConstants ? undefined : declared.get(name)
    const value = uniforms && ownProperty(uniforms, name)
    if (value !== undefined) fill(place, origin, value, uniform)
    else if (uniform) fill(place, origin, valueOf(place, uniform), uniform, true)
    else if (isRead)
      throw place.error(
        `the warp reads "${name}"; pass a value in the uniforms, as in { ${JSON.stringify(name)}: ${numbers.length === 1 ? 0 : `[${numbers.map(() => 0)}]`} }.`,
      )
    else numbers.fill(0)
  }
  return origins
}

/** Returns origins to the pool, without references to the caller's arrays. */
export function releaseOrigins(plan: InputPlan, origins: Origin[]) {
  for (const origin of origins) {
    origin.values = origin.numbers
    origin.isUniform = true
  }
  plan.origins.giveBack(origins)
}

/** Copies a value into the numbers of an origin. `isDeclared` is true if the value comes from the option `uniforms`. */
function fill(
  place: Place,
  { variable, numbers }: Origin,
  value: unknown,
  uniform: DeclaredUniform | undefined,
  isDeclared = false,
) {
  // The fast path, which allocates nothing. An array of one number is not a value of a declared uniform.
  const isPlain = !variable.read && !(uniform && (isWhole(uniform) || isSingle(value)))
  if (isPlain && copyNumbers(numbers, value)) return
  const uniformPlace = place.uniform(variable.name)
  const checked = uniform ? numbersFor(uniformPlace, uniform.shape, value, isDeclared) : value
  const converted = inputNumbers(uniformPlace, variable, checked)
  for (let i = 0; i < converted.length; i++) numbers[i] = converted[i]!
}

const valueOf = (place: Place, { value, numbers }: DeclaredUniform) =>
  value ? value() : scalarOrArray(numbers(place))

const isSingle = (value: unknown) => isList(value) && value.length < 2
