// A program as machine code: a wasm module whose bytes the evaluation's C++ writes, on the evaluation's own memory, where it
// holds nothing between two runs.
import type { Program } from '../core/module/kept-module.js'
import { type Evaluation, type Memory, afterFailure, allocate, isAlive } from './evaluation.js'

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

/** Of results, as the tables of arrays have it. */
export const sizeOf = ({ results }: Sink) => ({ size: results.length, isUniform: false })

/** So much is in the wasm's memory at a time, whatever the size of the mesh. */
export const verticesAtOnce = 4096

/** What such a module exports, as src/eval/machine_code.hpp says. */
interface Code {
  start(memory: number, at: number): void
  run(memory: number, end: number): void
}

/** For inputs and results like those that it was made for. */
export class MachineCode {
  /** Of the results of a whole batch, and of the last one. */
  private readonly batches = new Views()
  private readonly lasts = new Views()

  private constructor(
    readonly core: Evaluation,
    private readonly code: Code,
    private readonly inputsAt: readonly number[],
    private readonly resultsAt: readonly number[],
    private readonly shared: Uint32Array,
    private readonly sharedAt: number,
  ) {}

  /** Null if the program is too long; throws where the engine compiles nothing. */
  static of(
    program: Program,
    wanted: readonly number[],
    core: Evaluation,
    memory: Memory,
    inputs: readonly Stream[],
    sinks: readonly Sink[],
  ): MachineCode | null {
    let end = 0
    const place = (numbers: number) => (end += 4 * numbers) - 4 * numbers
    const inputsAt = inputs.map(({ size, isUniform }) =>
      place(size * (isUniform ? 1 : verticesAtOnce)),
    )
    const resultsAt = sinks.map(({ results }) => place(results.length * verticesAtOnce))
    const made = core._makeMachineCode(
      ...memory.program(program),
      ...memory.list(wanted),
      memory.table(inputs, inputsAt),
      inputs.length,
      memory.table(sinks.map(sizeOf), resultsAt),
      sinks.length,
      end,
    )
    if (!made) return null
    try {
      const words = core.HEAPU32
      const [module, size, shared, count, sharedAt] = words.subarray(made / 4, made / 4 + 5)
      const bytes = core.HEAPU8.slice(module, module! + size!)
      const { exports } = new WebAssembly.Instance(new WebAssembly.Module(bytes), {
        '': core.exports as WebAssembly.ModuleImports,
      })
      return new MachineCode(
        core,
        exports as unknown as Code,
        inputsAt,
        resultsAt,
        words.slice(shared! / 4, shared! / 4 + count!),
        sharedAt!,
      )
    } finally {
      core._dropMachineCode(made)
    }
  }

  /** Makes nothing, once it has run for the same arrays. */
  run(vertices: number, inputs: readonly Stream[], sinks: readonly Sink[]) {
    const { core } = this
    const at = allocate(core, this.sharedAt + this.shared.byteLength)
    try {
      this.runAt(at, vertices, inputs, sinks)
    } catch (error) {
      throw afterFailure(core, error)
    } finally {
      if (isAlive(core)) core._release(at)
    }
  }

  private runAt(at: number, vertices: number, inputs: readonly Stream[], sinks: readonly Sink[]) {
    const { core, code, inputsAt, resultsAt, shared, sharedAt } = this
    const floats = core.HEAPF32
    core.HEAPU32.set(shared, (at + sharedAt) / 4)
    for (let i = 0; i < inputs.length; i++) {
      const { values, size, isUniform } = inputs[i]!
      if (isUniform) copy(floats, (at + inputsAt[i]!) / 4, values, 0, size)
    }
    code.start(at, 0)
    for (let first = 0; first < vertices; first += verticesAtOnce) {
      const now = Math.min(verticesAtOnce, vertices - first)
      for (let i = 0; i < inputs.length; i++) {
        const { values, size, isUniform } = inputs[i]!
        if (!isUniform) copyFours(floats, (at + inputsAt[i]!) / 4, values, first, now, size)
      }
      code.run(at, 16 * Math.ceil(now / 4))
      const views = now === verticesAtOnce ? this.batches : this.lasts
      for (let i = 0; i < sinks.length; i++) {
        const { values, results } = sinks[i]!
        const size = results.length
        const from = (at + resultsAt[i]!) / 4
        if (now * size < worthAView) copy(values, first * size, floats, from, now * size)
        else values.set(views.of(i, floats, from, now * size), first * size)
      }
    }
  }
}

/** Parts of the wasm's memory, by a number of one's own. */
class Views {
  private readonly views: Float32Array[] = []

  /** The view of before, if it is that part still: calls mostly want the same. It is empty if the memory has grown. */
  of(i: number, floats: Float32Array, at: number, count: number): Float32Array {
    const kept = this.views[i]
    if (kept?.length === count && kept.byteOffset === 4 * at) return kept
    return (this.views[i] = floats.subarray(at, at + count))
  }
}

/** A caller's array in parts of a batch each, and what it was then. */
interface Parts {
  length: number
  size: number
  views: readonly Float32Array[]
}

/** Kept as long as the arrays: they mostly come again. */
const partsOf = new WeakMap<Float32Array, Parts>()

function batchOf(values: Float32Array, size: number, first: number): Float32Array {
  let parts = partsOf.get(values)
  // A resizable array may be longer now.
  if (parts?.size !== size || parts.length !== values.length)
    partsOf.set(values, (parts = cut(values, size)))
  return parts.views[first / verticesAtOnce]!
}

function cut(values: Float32Array, size: number): Parts {
  const { length } = values
  const count = size * verticesAtOnce
  const views = Array.from({ length: Math.ceil(length / count) }, (_, i) =>
    values.subarray(i * count, (i + 1) * count),
  )
  return { length, size, views }
}

/** The last of so many vertices is repeated to whole fours: these hold nothing that arithmetic is slow on. */
function copyFours(
  to: Float32Array,
  at: number,
  from: ArrayLike<number>,
  first: number,
  vertices: number,
  size: number,
) {
  const count = vertices * size
  if (count < worthAView || !(from instanceof Float32Array)) copy(to, at, from, first * size, count)
  else to.set(from.length === count ? from : batchOf(from, size, first), at)
  for (let i = vertices * size; i % (4 * size); i++) to[at + i] = to[at + i - size]!
}

/** Fewer are copied one by one: for `set` of a part there must be a view of it, which is an object. */
const worthAView = 256

export function copy(
  to: Float32Array,
  at: number,
  from: ArrayLike<number>,
  first: number,
  count: number,
) {
  // Each loop sees arrays of one kind: where kinds mix, engines make an object of each number.
  if (!(from instanceof Float32Array)) for (let i = 0; i < count; i++) to[at + i] = from[first + i]!
  else if (count < worthAView) for (let i = 0; i < count; i++) to[at + i] = from[first + i]!
  else to.set(from.subarray(first, first + count), at)
}
