// Runs programs on many vertices, in a wasm of its own, since it needs SIMD and the compiler does not. It is loaded when
// the first warp is evaluated, and holds nothing between two calls.
import { WarpError } from './errors.js'
import type { Program } from './evaluate.js'
import factory from './generated/evaluation.js'
import base64 from './generated/evaluation-wasm.js'
import type { Range } from './vertices.js'
import { instantiate } from './wasm.js'

/** js-bindings/evaluation.cpp. */
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
    return (evaluation ??= instantiate<Evaluation>(factory, base64))
  } catch (error) {
    if (error instanceof WebAssembly.CompileError)
      throw new WarpError(
        'evaluate: this browser has no WebAssembly SIMD, which a warp needs on the CPU; update it (Chrome 91, Firefox 89, Safari 16.4 and Node 16.4 have it).',
      )
    throw error
  }
}

/** Which of the program's inputs the wanted results depend on. */
export function inputsRead(program: Program, wanted: readonly number[]): boolean[] {
  const core = getEvaluation()
  const memory = new Memory(core)
  try {
    const sizes = program.inputs.map(({ shape: [columns, rows] }) => columns * rows)
    const total = sizes.reduce((sum, size) => sum + size, 0)
    const marks = memory.words(new Uint32Array(total))
    const words = memory.words(program.words)
    const { instructions } = program
    const wantedWords = memory.words(wanted)
    core._markInputs(
      words,
      program.words.length,
      instructions,
      wantedWords,
      wanted.length,
      marks,
      total,
    )
    let at = marks / 4
    return sizes.map((size) => core.HEAPU32.subarray(at, (at += size)).includes(1))
  } finally {
    memory.release()
  }
}

/** Runs `program` on so many vertices; `inputs` has all of its inputs in order. */
export function runProgram(
  program: Program,
  vertices: number,
  inputs: readonly Stream[],
  sinks: readonly Sink[],
) {
  const core = getEvaluation()
  const memory = new Memory(core)
  try {
    const atOnce = Math.min(vertices, verticesAtOnce)
    const words = memory.words(program.words)
    const wanted = sinks.flatMap(({ results }) => results)
    const wantedWords = memory.words(wanted)
    const streams = inputs.map(({ size, isUniform }) =>
      memory.floats(size * (isUniform ? 1 : atOnce)),
    )
    const results = sinks.map((sink) => memory.floats(sink.results.length * atOnce))
    const streamTable = memory.words(
      inputs.flatMap(({ size, isUniform }, i) => [streams[i]!, size, Number(isUniform)]),
    )
    const resultTable = memory.words(
      sinks.flatMap((sink, i) => [results[i]!, sink.results.length, 0]),
    )

    inputs.forEach(({ values, isUniform }, i) => {
      if (isUniform) core.HEAPF32.set(values, streams[i]! / 4)
    })
    const evaluator = core._openEvaluator(
      words,
      program.words.length,
      program.instructions,
      wantedWords,
      wanted.length,
      streamTable,
      inputs.length,
    )
    try {
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
    } finally {
      core._closeEvaluator(evaluator)
    }
  } finally {
    memory.release()
  }
}

/** Ranges of wanted results, from those of the program's inputs, number by number. */
export function boundProgram(
  program: Program,
  ranges: readonly Range[],
  wanted: readonly number[],
): Range[] {
  const core = getEvaluation()
  const memory = new Memory(core)
  try {
    const given = memory.doubles(ranges.flat())
    const results = memory.doubles(wanted.flatMap(() => [0, 0]))
    const words = memory.words(program.words)
    const wantedWords = memory.words(wanted)
    core._bound(
      words,
      program.words.length,
      program.instructions,
      given,
      ranges.length,
      wantedWords,
      wanted.length,
      results,
    )
    return wanted.map((_, i) => [
      core.HEAPF64[results / 8 + 2 * i]!,
      core.HEAPF64[results / 8 + 2 * i + 1]!,
    ])
  } finally {
    memory.release()
  }
}

function copy(to: Float32Array, at: number, from: ArrayLike<number>, first: number, count: number) {
  if (from instanceof Float32Array) to.set(from.subarray(first, first + count), at)
  else for (let i = 0; i < count; i++) to[at + i] = from[first + i]!
}

/** What one call allocates in the wasm, released together. */
class Memory {
  private readonly blocks: number[] = []

  constructor(private readonly core: Evaluation) {}

  private allocate(bytes: number): number {
    const block = this.core._allocate(Math.max(bytes, 8))
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

  release() {
    for (const block of this.blocks) this.core._release(block)
  }
}
