// Analyses a program without evaluating it.
import type { Variable } from '../core/expression/shapes.js'
import type { Range } from '../core/inputs/vertices.js'
import type { Program } from '../core/module/serialized-module.js'
import { evaluation, type Program as LoadedProgram } from '../wasm/evaluation.js'

/** Loads a program into the wasm, calls `work` with it, and unloads it. */
export const withProgram = <Result>(
  { words, instructions }: Program,
  work: (program: LoadedProgram) => Result,
): Result => evaluation.use(({ Program }) => new Program(words, instructions), work)

const sizeOf = ({ shape: [columns, rows] }: Variable) => columns * rows

/** Returns for each of the program's inputs whether the wanted results depend on it. */
export const inputsRead = (program: Program, wanted: readonly number[]): boolean[] =>
  withProgram(program, (loaded) =>
    Array.from(loaded.inputsRead(wanted, program.inputs.map(sizeOf)), Boolean),
  )

/**
 * Returns the range of each wanted result. `ranges` has the range of each component of the program's inputs. `budget` is the approximate
 * number of instructions that may be run: the lower it is, the wider the ranges get.
 */
export const boundProgram = (
  program: Program,
  ranges: readonly Range[],
  wanted: readonly number[],
  budget = Infinity,
): Range[] =>
  withProgram(program, (loaded) => {
    const bounds = loaded.bounds(ranges.flat(), wanted, budget)
    return wanted.map((_, i) => [bounds[2 * i]!, bounds[2 * i + 1]!])
  })
