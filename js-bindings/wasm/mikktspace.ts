// Computes MikkTSpace tangents with the wasm of the package mikktspace. The package's own loader needs an `import` of wasm, which bundlers
// and browsers lack, or files, which browsers lack. So we call the exports of the wasm ourselves, as that loader does.
import inlined from '../generated/mikktspace-wasm.js'
import { withBytes } from './inlined.js'

interface Exports extends WebAssembly.Exports {
  memory: WebAssembly.Memory
  /** Frees the three arrays, and writes the address and length of the result to `result`. */
  generateTangents(result: number, ...addressesAndLengths: number[]): void
  __wbindgen_malloc(bytes: number): number
  /** Adds to the stack pointer, and returns it. */
  __wbindgen_add_to_stack_pointer(bytes: number): number
}

let compiled: WebAssembly.Module | undefined

/**
 * Returns 4 numbers per vertex (a unit tangent and the sign of its bitangent) for triangles that share no vertices. MikkTSpace expects v
 * to increase upwards. Throws a `RangeError` or a `RuntimeError` if there is not enough memory.
 */
export function generateTangents(
  positions: Float32Array,
  normals: Float32Array,
  uvs: Float32Array,
): Float32Array {
  compiled ??= withBytes(inlined, (bytes) => new WebAssembly.Module(bytes))
  // An instance per call, since its memory never shrinks, and after a failure it must not be called again.
  const { exports } = new WebAssembly.Instance(compiled, {
    './mikktspace_module_bg.js': { __wbindgen_string_new: () => 0, __wbindgen_rethrow: fail },
  })
  const wasm = exports as Exports
  const result = wasm.__wbindgen_add_to_stack_pointer(-16)
  const inputs = [positions, normals, uvs].flatMap((numbers) => {
    const address = wasm.__wbindgen_malloc(numbers.byteLength)
    new Float32Array(wasm.memory.buffer, address, numbers.length).set(numbers)
    return [address, numbers.length]
  })
  wasm.generateTangents(result, ...inputs)
  const [address, length] = new Uint32Array(wasm.memory.buffer, result, 2)
  return new Float32Array(wasm.memory.buffer, address, length).slice()
}

function fail(): never {
  throw new WebAssembly.RuntimeError('unreachable')
}
