// How each wasm module starts: it is inlined, packed and in base64, and compiled synchronously, so that `createWarp`
// works in a plain `setup()`. The one that unpacks the others is not packed.
import unpackModule from './generated/unpack-wasm.js'

type Factory<Module> = (options: { wasmBinary: Uint8Array }) => Module

/** A new instance, with a memory of its own. */
export function instantiate<Module>(factory: Factory<Module>, base64: string): Module {
  return factory({ wasmBinary: unpack(decode(base64)) })
}

export const open = (base64: string) => new WebAssembly.Module(unpack(decode(base64)))

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
  const module = new WebAssembly.Module(decode(unpackModule))
  const unpacker = new WebAssembly.Instance(module).exports as unknown as Unpacker
  const input = unpacker.__heap_base.value as number
  const output = input + packed.length
  const size = new DataView(packed.buffer).getUint32(5, true)
  unpacker.memory.grow((output + size) >> 16)
  new Uint8Array(unpacker.memory.buffer).set(packed, input)
  unpacker.unpack(input + headerSize, output, size)
  return new Uint8Array(unpacker.memory.buffer, output, size)
}

function decode(text: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(text), (character) => character.charCodeAt(0))
}
