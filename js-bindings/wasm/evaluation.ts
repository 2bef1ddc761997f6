// What runs programs on many vertices: a wasm of its own, since it needs SIMD and the compiler does not. It is loaded when
// the first warp is evaluated, and holds nothing between two calls.
import { WarpError } from '../errors/errors.js'
import type { Program } from '../core/module/kept-module.js'
import inlined from '../generated/evaluation-wasm.js'
import type { Range } from '../core/inputs/vertices.js'
import { mathematics } from './mathematics.js'
import { megabytesOf, start } from './start.js'

/** A program, and which of its results. */
type Asked = [
  program: number,
  size: number,
  instructions: number,
  wanted: number,
  wantedCount: number,
]

/** evaluation.cpp. */
export interface Evaluation {
  _openEvaluator(...asked: [...Asked, inputs: number, inputCount: number]): number
  _runEvaluator(
    evaluator: number,
    vertices: number,
    inputs: number,
    inputCount: number,
    results: number,
    resultCount: number,
  ): void
  _closeEvaluator(evaluator: number): void
  _markInputs(...asked: [...Asked, marks: number, inputNumbers: number]): void
  _bound(
    program: number,
    size: number,
    instructions: number,
    ranges: number,
    rangeCount: number,
    wanted: number,
    wantedCount: number,
    results: number,
  ): void
  _makeMachineCode(
    ...asked: [
      ...Asked,
      inputs: number,
      inputCount: number,
      results: number,
      resultCount: number,
      end: number,
    ]
  ): number
  _dropMachineCode(code: number): void
  _allocate(bytes: number): number
  _release(memory: number): void
  _memoryInUse(): number

  readonly exports: WebAssembly.Exports
  readonly HEAPU8: Uint8Array
  readonly HEAPU32: Uint32Array
  readonly HEAPF32: Float32Array
  readonly HEAPF64: Float64Array
}

let evaluation: Evaluation | undefined

export function getEvaluation(): Evaluation {
  try {
    return (evaluation ??= start<Evaluation>(inlined, mathematics()))
  } catch (error) {
    if (error instanceof WebAssembly.CompileError)
      throw new WarpError(
        'A warp on the CPU needs WebAssembly with SIMD, which this browser lacks; update it (Chrome 114, Firefox 89, Safari 16.4 and Node have it).',
      )
    throw error
  }
}

/** Does `work` with memory in the wasm, and releases it whatever happens. */
export function withMemory<Result>(work: (core: Evaluation, memory: Memory) => Result): Result {
  const core = getEvaluation()
  const memory = new Memory(core)
  try {
    return work(core, memory)
  } catch (error) {
    throw afterFailure(core, error)
  } finally {
    if (isAlive(core)) memory.release()
  }
}

const tooLarge = ({ HEAPU8 }: Evaluation) =>
  new WarpError(
    `There is not enough memory to run so large a warp on the CPU, which already takes ${megabytesOf(HEAPU8)} MB.`,
  )

/** Memory in the wasm, to be released unless the wasm fails. */
export function allocate(core: Evaluation, bytes: number): number {
  const block = core._allocate(Math.max(bytes, 8))
  if (!block) throw tooLarge(core)
  return block
}

/** What to throw for an error of `core`, whose memory may then be in any state: the next call gets another. */
export function afterFailure(core: Evaluation, error: unknown): unknown {
  if (!(error instanceof WebAssembly.RuntimeError)) return error
  if (isAlive(core)) evaluation = undefined
  return tooLarge(core)
}

export const isAlive = (core: Evaluation) => evaluation === core

/**
 * How many bytes are held inside the wasm: between two calls always the same.
 * @internal
 */
export const evaluationMemoryInUse = (): number => getEvaluation()._memoryInUse()

/** Which of the program's inputs the wanted results depend on. */
export const inputsRead = (program: Program, wanted: readonly number[]): boolean[] =>
  withMemory((core, memory) => {
    const sizes = program.inputs.map(({ shape: [columns, rows] }) => columns * rows)
    const total = sizes.reduce((sum, size) => sum + size, 0)
    const marks = memory.words(new Uint32Array(total))
    core._markInputs(...memory.program(program), ...memory.list(wanted), marks, total)
    let at = marks / 4
    return sizes.map((size) => core.HEAPU32.subarray(at, (at += size)).includes(1))
  })

/** Ranges of wanted results, from those of the program's inputs, number by number. */
export const boundProgram = (
  program: Program,
  ranges: readonly Range[],
  wanted: readonly number[],
): Range[] =>
  withMemory((core, memory) => {
    const given = memory.doubles(ranges.flat())
    const results = memory.doubles(wanted.flatMap(() => [0, 0]))
    const [words, size, instructions] = memory.program(program)
    core._bound(words, size, instructions, given, ranges.length, ...memory.list(wanted), results)
    const at = results / 8
    return wanted.map((_, i) => [core.HEAPF64[at + 2 * i]!, core.HEAPF64[at + 2 * i + 1]!])
  })

/** What one call allocates in the wasm, released together. */
export class Memory {
  private readonly blocks: number[] = []
  evaluator = 0

  constructor(private readonly core: Evaluation) {}

  allocate(bytes: number): number {
    const block = allocate(this.core, bytes)
    this.blocks.push(block)
    return block
  }

  floats(count: number): number {
    return this.allocate(4 * count)
  }

  words(words: ArrayLike<number>): number {
    const at = this.allocate(4 * words.length)
    this.core.HEAPU32.set(words, at / 4)
    return at
  }

  doubles(numbers: ArrayLike<number>): number {
    const at = this.allocate(8 * numbers.length)
    this.core.HEAPF64.set(numbers, at / 8)
    return at
  }

  list(words: readonly number[]): [at: number, count: number] {
    return [this.words(words), words.length]
  }

  /** Of arrays at these addresses. */
  table(arrays: readonly { size: number; isUniform: boolean }[], at: readonly number[]): number {
    return this.words(arrays.flatMap(({ size, isUniform }, i) => [at[i]!, size, Number(isUniform)]))
  }

  program({ words, instructions }: Program): [at: number, size: number, instructions: number] {
    return [this.words(words), words.length, instructions]
  }

  release() {
    if (this.evaluator) this.core._closeEvaluator(this.evaluator)
    for (const block of this.blocks) this.core._release(block)
  }
}
