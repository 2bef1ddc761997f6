// How each wasm module starts: it is inlined, packed and in base64, and compiled synchronously, so that `createWarp`
// works in a plain `setup()`.
import { unpack } from './lzma.js'

type Factory<Module> = (options: { wasmBinary: Uint8Array }) => Module

/** A new instance, with a memory of its own. */
export function instantiate<Module>(factory: Factory<Module>, base64: string): Module {
  return factory({ wasmBinary: unpack(decode(base64)) })
}

function decode(text: string): Uint8Array {
  return Uint8Array.from(atob(text), (character) => character.charCodeAt(0))
}
