// Evaluates named expressions on the CPU, in double precision.
import type { Variable } from '../core/expression/shapes.js'
import { inputNumbers } from '../core/inputs/input-numbers.js'
import type { Program } from '../core/module/serialized-module.js'
import { ownProperty } from '../options/guards.js'
import { finiteDouble } from '../options/numbers.js'
import { Place } from '../options/place.js'
import { getCore } from '../wasm/core.js'

export type Numbers = number | ArrayLike<number>

const sizeOf = ({ shape: [columns, rows] }: Variable) => columns * rows
const totalSize = (variables: readonly Variable[]) =>
  variables.reduce((sum, variable) => sum + sizeOf(variable), 0)

const place = new Place('evaluate')

/** Evaluates `program`. `inputs` maps an input → its value. An input that is not in `read`, since it cancels out in the code, is 0. */
export function evaluate(
  program: Program | undefined,
  read: readonly Variable[],
  outputs: readonly Variable[],
  inputs: Readonly<Record<string, Numbers>>,
): Record<string, number | number[]> {
  if (!program)
    throw place.error(
      'only the GPU can call a function of glsl.fn or read an image by glsl.texture.',
    )
  const names = new Set(read.map(({ name }) => name))
  const numbers = program.inputs.flatMap((input) =>
    names.has(input.name) ? numbersOf(input, inputs) : Array<number>(sizeOf(input)).fill(0),
  )
  const results = runInDouble(program, numbers, totalSize(outputs))
  let start = 0
  return Object.fromEntries(
    outputs.map((output) => {
      const values = results.slice(start, (start += sizeOf(output)))
      return [output.name, values.length === 1 ? values[0]! : values]
    }),
  )
}

const numbersOf = (input: Variable, inputs: Readonly<Record<string, Numbers>>): number[] =>
  inputNumbers(
    place.part(`"${input.name}"`),
    input,
    ownProperty(inputs ?? {}, input.name),
    finiteDouble,
  )

/** Returns the first `resultCount` results of a program, from the numbers of its inputs. */
export const runInDouble = (
  { words, instructions }: Program,
  inputs: readonly number[],
  resultCount: number,
): number[] => [...getCore().evaluate(words, instructions, inputs, resultCount)]
