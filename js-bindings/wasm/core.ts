// Loads the wasm module of the compiler (core.cpp). It starts when the first warp is compiled.
import type { Bound } from '../generated/core-bindings.js'
import inlined from '../generated/core-wasm.js'
import factory from '../generated/core.js'
import { WasmInstance, outOfMemory, type Emscripten } from './instance.js'

export type { Module, Session } from '../generated/core-bindings.js'

/**
 * The bound compiler. Values, which are numbers, vectors or matrices, are identified by handles. `failed` of tables.ts is returned in
 * place of a handle if there is a problem, which the session's `problem()` describes.
 */
export type Core = Bound & Emscripten

export const core = new WasmInstance<Core>({
  factory,
  inlined,
  fail: outOfMemory(
    (megabytes) =>
      `There is not enough memory for so large a warp: the compiler already holds ${megabytes} MB.`,
  ),
})

export const getCore = () => core.get()

/**
 * Returns the number of bytes that the compiler holds in the wasm. Between warps, it is always the same.
 * @internal
 */
export const memoryInUse = (): number => getCore().memoryInUse()
