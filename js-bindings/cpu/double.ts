// Named expressions on the CPU, in double.
import { getCore } from '../wasm/core.js'
import { WarpError } from '../errors/errors.js'
import type { Program } from '../core/module/kept-module.js'
import { finiteDouble } from '../options/numbers.js'
import { own } from '../options/options.js'
import type { Variable } from '../core/expression/shapes.js'
import { inputNumbers } from '../core/inputs/input-numbers.js'

export type Numbers = number | ArrayLike<number>

const sizeOf = ({ shape: [columns, rows] }: Variable) => columns * rows
const totalSize = (variables: readonly Variable[]) =>
  variables.reduce((sum, variable) => sum + sizeOf(variable), 0)

/** Runs `program` on the values of its inputs by name; one that the text does not read, since it cancels, counts as 0. */
export function evaluate(
  program: Program | undefined,
  read: readonly Variable[],
  outputs: readonly Variable[],
  given: Readonly<Record<string, Numbers>>,
): Record<string, number | number[]> {
  if (!program)
    throw new WarpError(
      'evaluate: only the GPU can call a function of glsl.fn and read an image by glsl.texture.',
    )
  const names = new Set(read.map(({ name }) => name))
  const numbers = program.inputs.flatMap((input) =>
    names.has(input.name) ? numbersOf(input, given) : Array<number>(sizeOf(input)).fill(0),
  )
  const results = runInDouble(program, numbers, totalSize(outputs))
  let at = 0
  return Object.fromEntries(
    outputs.map((output) => {
      const values = results.slice(at, (at += sizeOf(output)))
      return [output.name, values.length === 1 ? values[0]! : values]
    }),
  )
}

const numbersOf = (input: Variable, given: Readonly<Record<string, Numbers>>): number[] => {
  const layout = input.shape[0] > 1 ? ', column by column' : ''
  const value = own(given ?? {}, input.name)
  return inputNumbers(`evaluate: "${input.name}"`, input, value, finiteDouble, layout)
}

/** The first results of a program, from the numbers of its inputs. */
export function runInDouble(
  { words, instructions }: Program,
  inputs: number[],
  resultCount: number,
): number[] {
  const core = getCore()
  const numbers = core._allocate(8 * (inputs.length + resultCount) + 4 * words.length)
  if (!numbers)
    throw new WarpError('evaluate: there is not enough memory to compute so many numbers.')
  try {
    const results = numbers + 8 * inputs.length
    const code = results + 8 * resultCount
    core.HEAPF64.set(inputs, numbers / 8)
    core.HEAPU32.set(words, code / 4)
    core._run(code, words.length, instructions, numbers, inputs.length, results, resultCount)
    return [...core.HEAPF64.subarray(results / 8, results / 8 + resultCount)]
  } finally {
    if (!core.isBroken) core._release(numbers)
  }
}
