// Runs programs on many vertices, in a wasm of its own, since it needs SIMD and the compiler does not. It is loaded when
// the first warp is evaluated, and holds nothing between two calls.
import { WarpError } from '../checks/errors.js'
import type { Program } from '../module/kept-module.js'
import inlined from '../generated/evaluation-wasm.js'
import type { Range } from '../inputs/vertices.js'
import { mathematics } from './mathematics.js'
import { start } from './start.js'

/** evaluation.cpp. */
interface Evaluation {
  _openEvaluator(
    program: number,
    size: number,
    instructions: number,
    wanted: number,
    wantedCount: number,
    inputs: number,
    inputCount: number,
  ): number
  _runEvaluator(
    evaluator: number,
    vertices: number,
    inputs: number,
    inputCount: number,
    results: number,
    resultCount: number,
  ): void
  _closeEvaluator(evaluator: number): void
  _markInputs(
    program: number,
    size: number,
    instructions: number,
    wanted: number,
    wantedCount: number,
    marks: number,
    inputNumbers: number,
  ): void
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
  _allocate(bytes: number): number
  _release(memory: number): void
  _memoryInUse(): number

  readonly HEAPU32: Uint32Array
  readonly HEAPF32: Float32Array
  readonly HEAPF64: Float64Array
}

/** The numbers of an input, `size` a vertex or, if it is uniform, `size` in all. */
export interface Stream {
  values: ArrayLike<number>
  size: number
  isUniform: boolean
}

/** Where results go, `results.length` of them a vertex, by their numbers in the program. */
export interface Sink {
  values: Float32Array
  results: readonly number[]
}

/** So much is in the wasm's memory at a time, whatever the size of the mesh. */
const verticesAtOnce = 4096

let evaluation: Evaluation | undefined

function getEvaluation(): Evaluation {
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
function withMemory<Result>(work: (core: Evaluation, memory: Memory) => Result): Result {
  const core = getEvaluation()
  const memory = new Memory(core)
  try {
    return work(core, memory)
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError)) throw error
    // Its memory may be in any state: the next call gets a new one.
    evaluation = undefined
    throw new WarpError(tooLarge)
  } finally {
    if (evaluation === core) memory.release()
  }
}

const tooLarge = 'There is not enough memory to run so large a warp on the CPU.'

/**
 * How many bytes are held inside the wasm: between two calls always the same.
 * @internal
 */
export const evaluationMemoryInUse = (): number => getEvaluation()._memoryInUse()

/** Found before, by program and wanted results. */
const knownReads = new WeakMap<Program, Map<string, boolean[]>>()

/** Which of the program's inputs the wanted results depend on. */
export function inputsRead(program: Program, wanted: readonly number[]): boolean[] {
  if (!knownReads.has(program)) knownReads.set(program, new Map())
  const known = knownReads.get(program)!
  const key = wanted.join()
  if (!known.has(key)) known.set(key, findInputsRead(program, wanted))
  return known.get(key)!
}

const findInputsRead = (program: Program, wanted: readonly number[]): boolean[] =>
  withMemory((core, memory) => {
    const sizes = program.inputs.map(({ shape: [columns, rows] }) => columns * rows)
    const total = sizes.reduce((sum, size) => sum + size, 0)
    const marks = memory.words(new Uint32Array(total))
    core._markInputs(...memory.program(program), ...memory.list(wanted), marks, total)
    let at = marks / 4
    return sizes.map((size) => core.HEAPU32.subarray(at, (at += size)).includes(1))
  })

/** Runs `program` on so many vertices; `inputs` has all of its inputs in order. */
export function runProgram(
  program: Program,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  withMemory((core, memory) => {
    const atOnce = Math.min(vertices, verticesAtOnce)
    const streams = inputs.map(({ size, isUniform }) =>
      memory.floats(size * (isUniform ? 1 : atOnce)),
    )
    const results = sinks.map((sink) => memory.floats(sink.results.length * atOnce))
    const streamTable = memory.words(
      inputs.flatMap(({ size, isUniform }, i) => [streams[i]!, size, Number(isUniform)]),
    )
    // Laid out as inputs are, of which none of these is uniform.
    const resultTable = memory.words(
      sinks.flatMap((sink, i) => [results[i]!, sink.results.length, 0]),
    )
    const wanted = memory.list(sinks.flatMap((sink) => sink.results))
    inputs.forEach(({ values, isUniform }, i) => {
      if (isUniform) core.HEAPF32.set(values, streams[i]! / 4)
    })

    const evaluator = core._openEvaluator(
      ...memory.program(program),
      ...wanted,
      streamTable,
      inputs.length,
    )
    memory.evaluator = evaluator
    for (let first = 0; first < vertices; first += atOnce) {
      const now = Math.min(atOnce, vertices - first)
      inputs.forEach(({ values, size, isUniform }, i) => {
        if (!isUniform) copy(core.HEAPF32, streams[i]! / 4, values, first * size, now * size)
      })
      core._runEvaluator(evaluator, now, streamTable, inputs.length, resultTable, sinks.length)
      sinks.forEach((sink, i) => {
        const size = sink.results.length
        const at = results[i]! / 4
        sink.values.set(core.HEAPF32.subarray(at, at + now * size), first * size)
      })
    }
  })
}

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

function copy(to: Float32Array, at: number, from: ArrayLike<number>, first: number, count: number) {
  if (from instanceof Float32Array) to.set(from.subarray(first, first + count), at)
  else for (let i = 0; i < count; i++) to[at + i] = from[first + i]!
}

/** What one call allocates in the wasm, released together. */
class Memory {
  private readonly blocks: number[] = []
  evaluator = 0

  constructor(private readonly core: Evaluation) {}

  private allocate(bytes: number): number {
    const block = this.core._allocate(Math.max(bytes, 8))
    if (!block) throw new WarpError(tooLarge)
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

  program({ words, instructions }: Program): [at: number, size: number, instructions: number] {
    return [this.words(words), words.length, instructions]
  }

  release() {
    if (this.evaluator) this.core._closeEvaluator(this.evaluator)
    for (const block of this.blocks) this.core._release(block)
  }
}
