// The bytes of a wasm module, which is inlined as text, and why a browser may refuse them. It is compiled synchronously, so that
// `createWarp` works in a plain `setup()`.
import { WarpError } from '../errors/errors.js'

/** By .scripts/lib/inline.mjs: frequent bytes are a letter each, the others two, which gzip packs as well as bytes. */
export interface Inlined {
  text: string
  letters: string
  /** The bytes that are a letter each; these and the others stand in their own order. */
  frequent: readonly number[]
}

/** Does `compile` with the bytes of a module, or throws a `WarpError` that says why the browser refuses all of them. */
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
