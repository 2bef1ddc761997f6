// How each wasm module starts: it is inlined as text, and compiled synchronously, so that `createWarp` works in a plain
// `setup()`.
import { WarpError } from '../errors/errors.js'

/** By .scripts/lib/inline.mjs: frequent bytes are a letter each, the others two, which gzip packs as well as bytes. */
export interface Inlined {
  text: string
  letters: string
  /** The bytes that are a letter each; these and the others stand in their own order. */
  frequent: readonly number[]
}

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

function compiling<Result>(
  inlined: Inlined,
  compile: (bytes: Uint8Array<ArrayBuffer>) => Result,
): Result {
  if (typeof WebAssembly !== 'object')
    throw new WarpError(
      'warpjet needs WebAssembly, which this browser lacks or has switched off, as the Lockdown Mode of iOS does.',
    )
  const bytes = decode(inlined)
  try {
    return compile(bytes)
  } catch (cause) {
    const why = refusal(cause)
    throw why ? Object.assign(new WarpError(why), { cause }) : cause
  }
}

/** Why a browser that has WebAssembly compiles none of it, or none of this size. */
function refusal(cause: unknown): string | undefined {
  // Chrome compiled no more than 4 KB in a page's own thread before version 114, and 8 MB since.
  if (cause instanceof RangeError && /main thread/.test(cause.message))
    return 'warpjet needs a browser that compiles WebAssembly of any size at once; update it (Chrome and Edge do since version 114).'
  try {
    new WebAssembly.Module(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0))
    return undefined
  } catch {
    return "warpjet needs WebAssembly, which the Content-Security-Policy of this page forbids; where the server's header or the page's <meta> tag sets that policy, add 'wasm-unsafe-eval' to its script-src, as in: script-src 'self' 'wasm-unsafe-eval'."
  }
}

function decode({ text, letters, frequent }: Inlined): Uint8Array<ArrayBuffer> {
  const ranks = new Uint8Array(128)
  for (let i = 0; i < letters.length; i++) ranks[letters.charCodeAt(i)] = i
  const count = letters.length
  const single = frequent.length
  const others = Array.from({ length: 256 }, (_, byte) => byte).filter(
    (byte) => !frequent.includes(byte),
  )
  const ordered = Uint8Array.of(...frequent, ...others)
  // In place, for there are no more bytes than letters; typed arrays take half as long as the text and an array would.
  const bytes = new TextEncoder().encode(text)
  let size = 0
  for (let i = 0; i < bytes.length; i++) {
    let rank = ranks[bytes[i]!]!
    if (rank >= single) rank = single + (rank - single) * count + ranks[bytes[++i]!]!
    bytes[size++] = ordered[rank]!
  }
  return bytes.subarray(0, size)
}
