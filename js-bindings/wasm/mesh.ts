// The module of meshes (mesh.cpp). It starts when it is first used, and holds nothing between two calls.
import factory from '../generated/mesh.js'
import type { Bound } from '../generated/mesh-bindings.js'
import inlined from '../generated/mesh-wasm.js'
import { type Emscripten, WasmInstance } from './instance.js'

export type { Mesh, Outcome } from '../generated/mesh-bindings.js'

export type MeshModule = Bound & Emscripten

/** The module has stopped: whoever knows which method the user called says what that means. */
export class MeshFailure extends Error {}

/** The module did not start. */
export class MeshStartFailure extends Error {}

export const meshes = new WasmInstance<MeshModule>({
  factory,
  inlined,
  fail: () => new MeshFailure(),
  explainStart: (cause) => Object.assign(new MeshStartFailure(), { cause }),
  maxKeptBytes: 2 ** 26,
})

/**
 * How many bytes the module holds inside its wasm: between two calls always the same. For tests, not for users.
 * @internal
 */
export const meshMemoryInUse = (): number => meshes.get().memoryInUse()
