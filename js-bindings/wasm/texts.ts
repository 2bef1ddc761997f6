// Modules whose functions take and give texts, as JavaScript calls them.
import { WarpError } from '../checks/errors.js'
import { mathematics } from './mathematics.js'
import { type Inlined, megabytesOf, start } from './start.js'

type Call = (...given: unknown[]) => unknown

interface Wasm {
  _makeText(size: number): number
  _textAddress(text: number): number
  _textSize(text: number): number
  _releaseText(text: number): void
  readonly HEAPU8: Uint8Array
  readonly HEAPU32: Uint32Array
  readonly HEAPF64: Float64Array
}

/**
 * Every function of C++ twice, with a `_` before its name as it is, and without one for texts, which those in `givesText`
 * give; and its memory as arrays. `giveUp` is called when the instance has stopped, for want of memory: what it holds may
 * then be in any state. `large` names what was too large then.
 */
export function startWithTexts<Module>(
  inlined: Inlined,
  givesText: ReadonlySet<string>,
  large: string,
  giveUp: () => void,
): Module {
  const wasm = start<Wasm>(inlined, mathematics())

  /** Texts cross as strings of C++, in UTF-8. */
  function give(text: string): number {
    const bytes = new TextEncoder().encode(text)
    const given = wasm._makeText(bytes.length)
    wasm.HEAPU8.set(bytes, wasm._textAddress(given))
    return given
  }
  function take(text: number): string {
    const at = wasm._textAddress(text)
    const taken = new TextDecoder().decode(wasm.HEAPU8.subarray(at, at + wasm._textSize(text)))
    wasm._releaseText(text)
    return taken
  }
  const withTexts =
    (name: string, call: Call): Call =>
    (...given) => {
      const texts: number[] = []
      const values = given.map((value) => {
        if (typeof value !== 'string') return value
        texts.push(give(value))
        return texts.at(-1)
      })
      const result = call(...values)
      texts.forEach(wasm._releaseText)
      return givesText.has(name) ? take(result as number) : result
    }

  const module: Record<string, unknown> = {}
  // Seven places are enough for all of them, and take half the time of a list.
  const guarded =
    (call: Call): Call =>
    (a, b, c, d, e, f, g) => {
      try {
        return call(a, b, c, d, e, f, g)
      } catch (error) {
        if (!isTrap(error)) throw error
        if (!module.isBroken) giveUp()
        module.isBroken = true
        // No more stack: the sketch calls itself without end, which JavaScript says better.
        if (error instanceof RangeError) throw error
        throw new WarpError(
          `There is not enough memory for so large a ${large}: the compiler already holds ${megabytesOf(wasm.HEAPU8)} MB.`,
        )
      }
    }
  for (const [name, call] of Object.entries(wasm)) {
    module[name] = guarded(call)
    module[name.slice(1)] = guarded(withTexts(name.slice(1), call))
  }
  return Object.defineProperties(module, {
    HEAPU32: { get: () => wasm.HEAPU32 },
    HEAPF64: { get: () => wasm.HEAPF64 },
  }) as Module
}

const isTrap = (error: unknown) =>
  error instanceof WebAssembly.RuntimeError || error instanceof RangeError
