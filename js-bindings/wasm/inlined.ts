// Decodes the bytes of an inlined wasm module, and explains why a browser rejects them. Modules are compiled synchronously, so that
// `createWarp` works in a plain `setup()`.
import { WarpError } from '../errors/errors.js'

/** A module as text, by .scripts/lib/inline.mjs: frequent bytes are one letter, others two, which gzip compresses as well as bytes. */
export interface Inlined {
  text: string
  letters: string
  /** The bytes that are one letter each, in the order of their letters. */
  frequent: readonly number[]
}

/** Calls `compile` with the bytes of a module. Throws a `WarpError` that explains why the browser rejects any module. */
export function withBytes<Result>(
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

function decode({ text, letters, frequent }: Inlined): Uint8Array<ArrayBuffer> {
  const ranks = new Uint8Array(128)
  for (let i = 0; i < letters.length; i++) ranks[letters.charCodeAt(i)] = i
  const count = letters.length
  const single = frequent.length
  const others = Array.from({ length: 256 }, (_, byte) => byte).filter(
    (byte) => !frequent.includes(byte),
  )
  const ordered = Uint8Array.of(...frequent, ...others)
  // Decodes in place, since there are no more bytes than letters. Typed arrays take half the time of a string and an array.
  const bytes = new TextEncoder().encode(text)
  let size = 0
  for (let i = 0; i < bytes.length; i++) {
    let rank = ranks[bytes[i]!]!
    if (rank >= single) rank = single + (rank - single) * count + ranks[bytes[++i]!]!
    bytes[size++] = ordered[rank]!
  }
  return bytes.subarray(0, size)
}
