// How each wasm module starts: it is inlined, packed and in base64, and compiled synchronously, so that `createWarp`
// works in a plain `setup()`. The one that unpacks the others is not packed.
import { WarpError } from './errors.js'
import unpackModule from './generated/unpack-wasm.js'

type Factory<Module> = (options: { wasmBinary: Uint8Array }) => Module

/** A new instance, with a memory of its own. */
export function instantiate<Module>(factory: Factory<Module>, base64: string): Module {
  const wasmBinary = unpack(decode(base64))
  return orTooLarge(() => factory({ wasmBinary }))
}

export function open(base64: string): WebAssembly.Module {
  const bytes = unpack(decode(base64))
  return orTooLarge(() => new WebAssembly.Module(bytes))
}

/** js-bindings/unpack.cpp. */
interface Unpacker {
  memory: WebAssembly.Memory
  /** Where memory is free. */
  __heap_base: WebAssembly.Global
  unpack(packed: number, output: number, outputSize: number): void
}

/** Of an .lzma file: the properties of the packing and two sizes. */
const headerSize = 13

function unpack(packed: Uint8Array): Uint8Array<ArrayBuffer> {
  const module = openUnpacker()
  const unpacker = new WebAssembly.Instance(module).exports as unknown as Unpacker
  const input = unpacker.__heap_base.value as number
  const output = input + packed.length
  const size = new DataView(packed.buffer).getUint32(5, true)
  unpacker.memory.grow((output + size) >> 16)
  new Uint8Array(unpacker.memory.buffer).set(packed, input)
  unpacker.unpack(input + headerSize, output, size)
  return new Uint8Array(unpacker.memory.buffer, output, size)
}

/** Small, and of the first WebAssembly there was: what refuses it refuses all of them. */
function openUnpacker(): WebAssembly.Module {
  if (typeof WebAssembly !== 'object')
    throw new WarpError(
      'warpjet needs WebAssembly, which this browser lacks or has switched off, as the Lockdown Mode of iOS does.',
    )
  try {
    return new WebAssembly.Module(decode(unpackModule))
  } catch (cause) {
    const error = new WarpError(
      "warpjet needs WebAssembly, which the Content-Security-Policy of this page forbids; where the server's header or the page's <meta> tag sets that policy, add 'wasm-unsafe-eval' to its script-src, as in: script-src 'self' 'wasm-unsafe-eval'.",
    )
    throw Object.assign(error, { cause })
  }
}

/** Chrome compiled no more than 4 KB in a page's own thread before version 114, and 8 MB since. */
function orTooLarge<Result>(start: () => Result): Result {
  try {
    return start()
  } catch (cause) {
    if (!(cause instanceof RangeError && /main thread/.test(cause.message))) throw cause
    const error = new WarpError(
      'warpjet needs a browser that compiles WebAssembly of any size at once; update it (Chrome and Edge do since version 114).',
    )
    throw Object.assign(error, { cause })
  }
}

function decode(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(text), (character) => character.charCodeAt(0))
}
