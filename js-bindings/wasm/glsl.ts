// Loads the wasm module of the front end for shader source (glsl.cpp). It starts when the first source is parsed.
import type { Bound } from '../generated/glsl-bindings.js'
import inlined from '../generated/glsl-wasm.js'
import factory from '../generated/glsl.js'
import { WasmInstance, outOfMemory, type Emscripten } from './instance.js'

export type * from '../generated/glsl-bindings.js'

export const glsl = new WasmInstance<Bound & Emscripten>({
  factory,
  inlined,
  fail: outOfMemory(
    (megabytes) =>
      `There is not enough memory for so large a shader: the compiler already holds ${megabytes} MB.`,
  ),
})

/**
 * Returns the number of bytes that the front end holds in the wasm. Between calls, it is always the same.
 * @internal
 */
export const glslMemoryInUse = (): number => glsl.get().memoryInUse()
