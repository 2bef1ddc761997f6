// Loads the wasm module for meshes (mesh.cpp). It starts when it is first used, and holds no data between two calls.
import type { Bound } from '../generated/mesh-bindings.js'
import inlined from '../generated/mesh-wasm.js'
import factory from '../generated/mesh.js'
import { WasmInstance, type Emscripten } from './instance.js'

export type { Mesh, Outcome } from '../generated/mesh-bindings.js'

export type MeshModule = Bound & Emscripten

/** Thrown if the module has failed. The caller, who knows the function that the user called, words the message. */
export class MeshFailure extends Error {}

/** Thrown if the module does not start. */
export class MeshStartFailure extends Error {}

export const meshes = new WasmInstance<MeshModule>({
  factory,
  inlined,
  fail: () => new MeshFailure(),
  explainStart: (cause) => Object.assign(new MeshStartFailure(), { cause }),
  maxKeptBytes: 2 ** 26,
})

/**
 * Returns the number of bytes that the module holds in its wasm. Between calls, it is always the same. For tests only.
 * @internal
 */
export const meshMemoryInUse = (): number => meshes.get().memoryInUse()
