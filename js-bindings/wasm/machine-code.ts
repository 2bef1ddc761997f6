// A program as machine code: a wasm module whose bytes the evaluation's C++ writes, on the evaluation's own memory, where it
// holds nothing between two runs.
import type { Program } from '../module/kept-module.js'
import type { Evaluation, Memory } from './evaluation.js'

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

  run(memory: Memory, vertices: number, inputs: readonly Stream[], sinks: readonly Sink[]) {
    const { core, code, inputsAt, resultsAt, shared, sharedAt } = this
    const at = memory.allocate(sharedAt + shared.byteLength)
    const floats = core.HEAPF32
    core.HEAPU32.set(shared, (at + sharedAt) / 4)
    for (let i = 0; i < inputs.length; i++) {
      const { values, isUniform } = inputs[i]!
      if (isUniform) floats.set(values, (at + inputsAt[i]!) / 4)
    }
    code.start(at, 0)
    for (let first = 0; first < vertices; first += verticesAtOnce) {
      const now = Math.min(verticesAtOnce, vertices - first)
      for (let i = 0; i < inputs.length; i++) {
        const { values, size, isUniform } = inputs[i]!
        if (!isUniform) copyFours(floats, (at + inputsAt[i]!) / 4, values, first, now, size)
      }
      code.run(at, 16 * Math.ceil(now / 4))
      for (let i = 0; i < sinks.length; i++) {
        const { values, results } = sinks[i]!
        const size = results.length
        copy(values, first * size, floats, (at + resultsAt[i]!) / 4, now * size)
      }
    }
  }
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
  copy(to, at, from, first * size, vertices * size)
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
