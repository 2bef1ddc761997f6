// Loads the wasm module that evaluates programs at many vertices (evaluation.cpp). It is separate from the compiler's, which does not need
// SIMD. It starts when the first warp is evaluated, and frees its memory after each call.
import type { Bound } from '../generated/evaluation-bindings.js'
import inlined from '../generated/evaluation-wasm.js'
import factory from '../generated/evaluation.js'
import { WasmInstance, explainNoSimd, outOfMemory, type Emscripten } from './instance.js'

export type { Code, InputArray, Program } from '../generated/evaluation-bindings.js'

export type Evaluation = Bound &
  Emscripten & {
    /** The imports of machine code. */
    readonly imports: WebAssembly.ModuleImports
  }

export const evaluation = new WasmInstance<Evaluation>({
  factory: (options) => withImports(factory(options) as Bound & Emscripten),
  inlined,
  fail: outOfMemory(
    (megabytes) =>
      `There is not enough memory to evaluate so large a warp on the CPU, which already takes ${megabytes} MB.`,
  ),
  explainStart: explainNoSimd('A warp on the CPU'),
})

function withImports(bound: Bound & Emscripten): Evaluation {
  const memory = Object.values(bound.asm).find((each) => each instanceof WebAssembly.Memory)
  const lanes = Object.entries(bound).filter(([name]) => name.startsWith('_lanes_'))
  const functions = lanes.map(([name, call]) => [name.slice(1), call])
  return Object.assign(bound, { imports: { memory, ...Object.fromEntries(functions) } })
}

/**
 * Returns the number of bytes held in the wasm. Between calls, it is always the same.
 * @internal
 */
export const evaluationMemoryInUse = (): number => evaluation.get().memoryInUse()
