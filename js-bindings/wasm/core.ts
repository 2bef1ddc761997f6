// The compiler (core.cpp). It starts with the first warp.
import factory from '../generated/core.js'
import type { Bound } from '../generated/core-bindings.js'
import inlined from '../generated/core-wasm.js'
import { type Emscripten, WasmInstance, outOfMemory } from './instance.js'

export type { Module, Session } from '../generated/core-bindings.js'

/**
 * Handles are numbers that stand for values: numbers, vectors and matrices alike; `failed` of tables.ts stands in the place
 * of one that there cannot be, and then the session's `problem` says why.
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
 * How many bytes the compiler holds inside the wasm. Between two warps it is always the same.
 * @internal
 */
export const memoryInUse = (): number => getCore().memoryInUse()
