// A program as machine code: a wasm module whose bytes the C++ of the evaluation module writes. It uses the memory of the evaluation
// module, and holds none of it between two runs.
import type { Program } from '../core/module/serialized-module.js'
import {
  evaluation,
  type Evaluation,
  type InputArray,
  type Code as WrittenCode,
} from '../wasm/evaluation.js'
import { Views } from '../wasm/views.js'
import { withProgram } from './analyse-program.js'

/** The numbers of an input: `size` per vertex or, if it is uniform, `size` in total. */
export interface Stream extends InputArray {
  values: ArrayLike<number>
}

/** Receives results of the program. */
export interface Sink {
  /** `results.length` floats per vertex. */
  values: Float32Array
  /** Numbers of the results in the program. */
  results: readonly number[]
}

export const sizeOf = ({ results }: Sink) => results.length

/** The number of vertices per batch: only one batch is in the wasm's memory at a time, whatever the size of the mesh. */
export const batchSize = 4096

/** The exports of the written module; src/eval/machine_code.hpp documents them. */
interface Code {
  start(memory: number, start: number): void
  run(memory: number, end: number): void
}

/** Machine code of a program for some of its results. Each input must be uniform or per vertex as it was when the code was made. */
export class MachineCode {
  /** Views of the results of full batches, and of the last batch. */
  private readonly batches = new Views()
  private readonly lastBatches = new Views()

  private constructor(
    readonly core: Evaluation,
    private readonly code: Code,
    private readonly written: WrittenCode,
  ) {}

  /**
   * Compiles a program; returns `null` if it is too long. Throws if the JavaScript engine forbids to compile wasm, such as by a page's CSP.
   */
  static compile(
    program: Program,
    wanted: readonly number[],
    inputs: readonly Stream[],
    sinks: readonly Sink[],
  ): MachineCode | null {
    const core = evaluation.get()
    const written = withProgram(program, (loaded) =>
      loaded.code(wanted, inputs, sinks.map(sizeOf), batchSize),
    )
    if (!written.module.length) return null
    const module = new WebAssembly.Module(written.module as Uint8Array<ArrayBuffer>)
    const { exports } = new WebAssembly.Instance(module, { '': core.imports })
    const { start, run } = exports as unknown as Code
    const code = { start: evaluation.guard(core, start), run: evaluation.guard(core, run) }
    return new MachineCode(core, code, written)
  }

  /** Evaluates vertices. Creates no garbage if it has run with the same arrays before. */
  run(vertices: number, inputs: readonly Stream[], sinks: readonly Sink[]) {
    const { core, written } = this
    const address = core._malloc(written.sharedAt + written.shared.byteLength)
    try {
      this.runAt(address, vertices, inputs, sinks)
    } finally {
      if (!core.isBroken) core._free(address)
    }
  }

  private runAt(
    address: number,
    vertices: number,
    inputs: readonly Stream[],
    sinks: readonly Sink[],
  ) {
    const { core, code } = this
    const { inputsAt, resultsAt, shared, sharedAt } = this.written
    const floats = core.HEAPF32
    core.HEAPU32.set(shared, (address + sharedAt) / 4)
    for (let i = 0; i < inputs.length; i++) {
      const { values, size, isUniform } = inputs[i]!
      if (isUniform) copy(floats, (address + inputsAt[i]!) / 4, values, 0, size)
    }
    code.start(address, 0)
    for (let first = 0; first < vertices; first += batchSize) {
      const count = Math.min(batchSize, vertices - first)
      for (let i = 0; i < inputs.length; i++) {
        const { values, size, isUniform } = inputs[i]!
        if (!isUniform) copyFours(floats, (address + inputsAt[i]!) / 4, values, first, count, size)
      }
      code.run(address, 16 * Math.ceil(count / 4))
      const views = count === batchSize ? this.batches : this.lastBatches
      for (let i = 0; i < sinks.length; i++) {
        const { values, results } = sinks[i]!
        const size = results.length
        const from = (address + resultsAt[i]!) / 4
        if (count * size < minViewLength) copy(values, first * size, floats, from, count * size)
        else values.set(views.get(i, floats, from, count * size), first * size)
      }
    }
  }
}

/** Views of a caller's array, one per batch. */
interface Batches {
  /** The length of the array when the views were made. */
  length: number
  /** The number of floats per vertex. */
  size: number
  views: readonly Float32Array[]
}

/** Maps an array → its views. They are cached, since most arrays are passed again. */
const batchesOf = new WeakMap<Float32Array, Batches>()

function batchOf(values: Float32Array, size: number, first: number): Float32Array {
  let batches = batchesOf.get(values)
  // A resizable array may be longer now.
  if (batches?.size !== size || batches.length !== values.length)
    batchesOf.set(values, (batches = splitIntoBatches(values, size)))
  return batches.views[first / batchSize]!
}

function splitIntoBatches(values: Float32Array, size: number): Batches {
  const { length } = values
  const count = size * batchSize
  const views = Array.from({ length: Math.ceil(length / count) }, (_, i) =>
    values.subarray(i * count, (i + 1) * count),
  )
  return { length, size, views }
}

/** Copies vertices, and repeats the last one up to a multiple of 4: SIMD evaluates 4 at a time, and would be slow on leftover denormals. */
function copyFours(
  to: Float32Array,
  at: number,
  from: ArrayLike<number>,
  first: number,
  vertices: number,
  size: number,
) {
  const count = vertices * size
  if (count < minViewLength || !(from instanceof Float32Array))
    copy(to, at, from, first * size, count)
  else to.set(from.length === count ? from : batchOf(from, size, first), at)
  for (let i = vertices * size; i % (4 * size); i++) to[at + i] = to[at + i - size]!
}

/** Shorter parts are copied number by number, since `set` needs a view, which is an object. */
const minViewLength = 256

export function copy(
  to: Float32Array,
  at: number,
  from: ArrayLike<number>,
  first: number,
  count: number,
) {
  // Each loop sees arrays of one type: where types mix, engines allocate an object for each number.
  if (!(from instanceof Float32Array)) for (let i = 0; i < count; i++) to[at + i] = from[first + i]!
  else if (count < minViewLength) for (let i = 0; i < count; i++) to[at + i] = from[first + i]!
  else to.set(from.subarray(first, first + count), at)
}
