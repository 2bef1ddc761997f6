// How each wasm module starts: it is inlined as text, and compiled synchronously, so that `createWarp` works in a plain
// `setup()`.
import { type Inlined, withBytes as compiling } from './inlined.js'

export type { Inlined }

/** Whole ones, of what a module holds. */
export const megabytesOf = (memory: ArrayBufferView) => Math.ceil(memory.byteLength / 2 ** 20)

/**
 * A new instance of a module that needs none of Emscripten's JavaScript: as that would, it has every function with a `_`
 * before its name, and the memory as arrays; `exports` has them as they are.
 */
export function start<Module>(inlined: Inlined, imports: WebAssembly.ModuleImports = {}): Module {
  const module = compiling(inlined, (bytes) => new WebAssembly.Module(bytes))
  const { exports } = new WebAssembly.Instance(module, {
    env: { emscripten_notify_memory_growth() {}, ...imports },
    wasi_snapshot_preview1: { proc_exit },
  })
  const { memory, _initialize, ...functions } = exports as {
    memory: WebAssembly.Memory
    _initialize(): void
  }
  _initialize()
  const named = Object.entries(functions).map(([name, call]) => [`_${name}`, call])
  // Made anew only when the memory has grown, which leaves the arrays of before empty.
  const view = <View extends { length: number }>(Kind: new (memory: ArrayBuffer) => View) => {
    let kept = new Kind(memory.buffer)
    return { get: () => (kept.length ? kept : (kept = new Kind(memory.buffer))) }
  }
  return Object.defineProperties(Object.fromEntries(named), {
    exports: { value: exports },
    HEAPU8: view(Uint8Array),
    HEAPU32: view(Uint32Array),
    HEAPF32: view(Float32Array),
    HEAPF64: view(Float64Array),
  }) as Module
}

/** How a C++ program ends, which ours does only where memory does. */
function proc_exit(): never {
  throw new WebAssembly.RuntimeError('warpjet has no more memory')
}

/** What Emscripten's own `factory` makes of a module. */
export const instantiate = <Module>(
  factory: (options: { wasmBinary: Uint8Array }) => Module,
  inlined: Inlined,
): Module => compiling(inlined, (wasmBinary) => factory({ wasmBinary }))
