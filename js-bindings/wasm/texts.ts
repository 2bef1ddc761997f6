// Modules whose functions take and give texts, as JavaScript calls them.
import { WarpError } from '../errors/errors.js'
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

  const encoder = new TextEncoder()
  const decoder = new TextDecoder()
  const bytesOf = (text: number, size: number) => {
    const at = wasm._textAddress(text)
    return wasm.HEAPU8.subarray(at, at + size)
  }
  /** Texts cross as strings of C++, in UTF-8: most are ASCII, and written where they belong at once. */
  function give(text: string): number {
    const given = wasm._makeText(text.length)
    if (encoder.encodeInto(text, bytesOf(given, text.length)).read === text.length) return given
    wasm._releaseText(given)
    const bytes = encoder.encode(text)
    const longer = wasm._makeText(bytes.length)
    bytesOf(longer, bytes.length).set(bytes)
    return longer
  }
  function take(text: number): string {
    const taken = decoder.decode(bytesOf(text, wasm._textSize(text)))
    wasm._releaseText(text)
    return taken
  }
  const withTexts = (name: string, call: Call): Call => {
    const gives = givesText.has(name)
    return (...given) => {
      const texts: number[] = []
      given.forEach((value, i) => {
        if (typeof value === 'string') texts.push((given[i] = give(value)) as number)
      })
      const result = call(...given)
      texts.forEach(wasm._releaseText)
      return gives ? take(result as number) : result
    }
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
