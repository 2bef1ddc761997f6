// Decodes the bytes of an inlined wasm module, and explains why a browser rejects them. Modules are compiled synchronously, so that
// `createWarp` works in a plain `setup()`.
import { WarpError } from '../errors/errors.js'

/**
 * Calls `compile` with the bytes of a module, which is inlined as hexadecimal digits. Throws a `WarpError` that explains why the browser
 * rejects any module.
 */
export function withBytes<Result>(
  digits: string,
  compile: (bytes: Uint8Array<ArrayBuffer>) => Result,
): Result {
  if (typeof WebAssembly !== 'object')
    throw new WarpError(
      'warpjet needs WebAssembly, which this browser lacks or has switched off, as the Lockdown Mode of iOS does.',
    )
  const bytes = decode(digits)
  try {
    return compile(bytes)
  } catch (cause) {
    const reason = explainRejection(cause)
    throw reason ? Object.assign(new WarpError(reason), { cause }) : cause
  }
}

/** Explains why a browser with WebAssembly compiles no module, or none of this size; `undefined` for another reason. */
function explainRejection(cause: unknown): string | undefined {
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

/**
 * Browsers have decoded hexadecimal digits natively since 2025, in a hundredth of the time that a loop takes before an engine has
 * optimized it. Node 20 and 22 have `Buffer`.
 */
function decode(digits: string): Bytes {
  const { Buffer } = globalThis as { Buffer?: { from(text: string, encoding: 'hex'): Bytes } }
  const { fromHex } = Uint8Array as { fromHex?: (text: string) => Bytes }
  if (fromHex) return fromHex.call(Uint8Array, digits)
  return Buffer ? Buffer.from(digits, 'hex') : decodeByLoop(digits)
}

type Bytes = Uint8Array<ArrayBuffer>

function decodeByLoop(digits: string): Bytes {
  const values = new Uint8Array(128)
  for (let i = 0; i < 16; i++) values[i.toString(16).charCodeAt(0)] = i
  // Decodes in place. Typed arrays take half the time of a string and an array.
  const bytes = new TextEncoder().encode(digits)
  const size = bytes.length / 2
  for (let i = 0; i < size; i++)
    bytes[i] = (values[bytes[2 * i]!]! << 4) | values[bytes[2 * i + 1]!]!
  return bytes.subarray(0, size)
}
